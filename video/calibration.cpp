// SPDX-License-Identifier: MIT
#include "graspdb/video/calibration.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;

constexpr int kMostPixels = 100'000;  // a side
constexpr std::size_t kMostBytes = std::size_t{1} << 20;

[[noreturn]] void refuse(const fs::path& file, const std::string& key, const std::string& expected,
                         const std::string& found) {
  throw Error({file.string(), key, expected, found});
}

CameraCalibration checked(const CameraCalibration& read, const fs::path& file) {
  const Intrinsics& camera = read.camera;
  const auto is_focal = [](double focal) { return focal > 0 && std::isfinite(focal); };
  if (!is_focal(camera.fx) || !is_focal(camera.fy))
    refuse(file, "focal lengths", "above 0", fmt::format("{} and {}", camera.fx, camera.fy));
  if (!std::isfinite(camera.cx) || !std::isfinite(camera.cy))
    refuse(file, "principal point", "two numbers", fmt::format("{}, {}", camera.cx, camera.cy));
  const auto is_side = [](int side) { return side >= 0 && side <= kMostPixels; };
  if (!is_side(camera.width) || !is_side(camera.height) ||
      (camera.width > 0) != (camera.height > 0))
    refuse(file, "size of the pictures", "up to 100,000 pixels a side",
           fmt::format("{} x {}", camera.width, camera.height));
  return read;
}

CameraCalibration of_matrix(const std::vector<double>& k, const fs::path& file) {
  if (k[3] != 0 || k[6] != 0 || k[7] != 0 || k[8] != 1)
    refuse(file, "camera matrix", "fx, s, cx; 0, fy, cy; 0, 0, 1",
           fmt::format("{}", fmt::join(k, ", ")));
  if (k[1] != 0) refuse(file, "camera matrix", "no skew", fmt::format("{}", k[1]));
  return {{.fx = k[0], .fy = k[4], .cx = k[2], .cy = k[5]}};
}

// An entry's names, of which messages tell the first.
using Names = std::initializer_list<const char*>;

YAML::Node first_of(const YAML::Node& map, Names names) {
  for (const char* name : names) {
    if (YAML::Node node = map[name]; node.IsDefined()) return node;
  }
  return YAML::Node(YAML::NodeType::Undefined);
}

// Of a matrix row by row, or a list; none for an entry that is not there.
std::vector<double> numbers_of(const YAML::Node& map, Names names, const fs::path& file) {
  const YAML::Node node = first_of(map, names);
  if (!node.IsDefined()) return {};
  const YAML::Node list = node.IsMap() ? node["data"] : node;
  if (!list.IsDefined() || !list.IsSequence())
    refuse(file, *names.begin(), "a matrix or a list of numbers", "something else");
  std::vector<double> numbers;
  for (const YAML::Node& entry : list) {
    numbers.push_back(entry.as<double>(std::numeric_limits<double>::quiet_NaN()));
    if (std::isnan(numbers.back())) refuse(file, *names.begin(), "numbers", "something else");
  }
  return numbers;
}

// 0 for an entry that is not there.
int side_of(const YAML::Node& map, Names names, const fs::path& file) {
  const YAML::Node node = first_of(map, names);
  const int side = node.IsDefined() ? node.as<int>(-1) : 0;
  if (side < 0) refuse(file, *names.begin(), "a whole number", "something else");
  return side;
}

// YAML, or JSON, which is YAML as well. OpenCV's own reader is not used: an altered file can end
// the program or keep it for ever.
CameraCalibration read_opencv(const std::string& text, const fs::path& file) {
  const YAML::Node all = YAML::Load(text);
  if (!all.IsMap()) refuse(file, "", "a calibration of OpenCV", "something else");
  const std::vector<double> matrix =
      numbers_of(all, {"camera_matrix", "Camera_Matrix", "cameraMatrix", "K"}, file);
  if (matrix.size() != 9)
    refuse(file, "camera_matrix", "a matrix of 3 x 3", fmt::format("{} numbers", matrix.size()));
  CameraCalibration read = of_matrix(matrix, file);
  read.camera.width = side_of(all, {"image_width", "image_Width"}, file);
  read.camera.height = side_of(all, {"image_height", "image_Height"}, file);
  const std::vector<double> bends = numbers_of(
      all, {"distortion_coefficients", "Distortion_Coefficients", "distCoeffs", "D"}, file);
  read.distorted = std::ranges::any_of(bends, [](double bend) { return bend != 0; });
  return read;
}

// COLMAP's models of pinholes, and how many focal lengths they have.
struct ColmapModel {
  const char* name;
  int focal_lengths, bends;
};
constexpr std::array kColmapModels = {
    ColmapModel{"SIMPLE_PINHOLE", 1, 0}, ColmapModel{"PINHOLE", 2, 0},
    ColmapModel{"SIMPLE_RADIAL", 1, 1},  ColmapModel{"RADIAL", 1, 2},
    ColmapModel{"OPENCV", 2, 4},         ColmapModel{"FULL_OPENCV", 2, 8}};

// "1 PINHOLE 640 480 fx fy cx cy". Its pixels' corners are whole, ours their centres.
CameraCalibration read_colmap(const std::string& line, const fs::path& file) {
  std::istringstream words(line);
  std::string number, name;
  CameraCalibration read;
  words >> number >> name >> read.camera.width >> read.camera.height;
  const auto* model = std::ranges::find(
      kColmapModels, name, [](const ColmapModel& known) { return std::string_view(known.name); });
  if (!words || model == kColmapModels.end())
    refuse(file, name, "a pinhole of COLMAP, such as PINHOLE or OPENCV", line);
  std::vector<double> parameters(static_cast<std::size_t>(model->focal_lengths + 2 + model->bends));
  for (double& parameter : parameters) words >> parameter;
  if (!words || !(words >> std::ws).eof())
    refuse(file, name, fmt::format("{} parameters", parameters.size()), line);
  const auto at = [&](int i) { return parameters[static_cast<std::size_t>(i)]; };
  read.camera.fx = at(0);
  read.camera.fy = at(model->focal_lengths - 1);
  read.camera.cx = at(model->focal_lengths) - 0.5;
  read.camera.cy = at(model->focal_lengths + 1) - 0.5;
  read.distorted = std::any_of(parameters.end() - model->bends, parameters.end(),
                               [](double bend) { return bend != 0; });
  return read;
}

// Those that are neither empty nor begin with #.
std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream all(text);
  for (std::string line; std::getline(all, line);) {
    const auto first = line.find_first_not_of(" \t\r");
    if (first != std::string::npos && line[first] != '#') lines.push_back(line.substr(first));
  }
  return lines;
}

// Nine numbers, with commas or without.
std::vector<double> numbers_of(std::vector<std::string> lines) {
  std::vector<double> numbers;
  for (std::string& line : lines) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      double number = 0;
      const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), number);
      if (fault != std::errc() || end != word.data() + word.size()) return {};
      numbers.push_back(number);
    }
  }
  return numbers;
}

CameraCalibration read_plain(const std::string& text, const fs::path& file) {
  const std::vector<std::string> lines = lines_of(text);
  const std::vector<double> numbers = numbers_of(lines);
  if (numbers.size() == 9) return of_matrix(numbers, file);
  if (lines.size() == 1) return read_colmap(lines.front(), file);
  refuse(file, "", "a calibration of OpenCV, one camera of COLMAP's cameras.txt, or nine numbers",
         fmt::format("{} lines of something else", lines.size()));
}

// 0 of a text without one.
char first_letter(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  return first == std::string::npos ? '\0' : text[first];
}

CameraCalibration read_any(const std::string& text, const fs::path& file) {
  // OpenCV's first line, "%YAML:1.0", is no directive of YAML.
  if (text.starts_with("%YAML"))
    return read_opencv(text.substr(std::min(text.size(), text.find('\n'))), file);
  if (first_letter(text) == '{') return read_opencv(text, file);
  if (first_letter(text) == '<') refuse(file, "", "a calibration as YAML or JSON", "XML");
  return read_plain(text, file);
}

}  // namespace

CameraCalibration read_calibration(const fs::path& file) {
  const std::string text = read_text(file);
  if (text.size() > kMostBytes)
    refuse(file, "", "a calibration of at most 1 MiB", fmt::format("{} bytes", text.size()));
  try {
    return checked(read_any(text, file), file);
  } catch (const YAML::Exception& error) {
    refuse(file, "", "a calibration of OpenCV", error.what());
  }
}

Intrinsics scaled_to(const Intrinsics& camera, int width, int height, const fs::path& file) {
  Intrinsics scaled = camera;
  scaled.width = width;
  scaled.height = height;
  if (camera.width == 0) return scaled;
  const double scale = static_cast<double>(width) / camera.width;
  if (std::abs(scale * camera.height - height) > 1)
    refuse(file, "size of the pictures", fmt::format("the shape of {} x {}", width, height),
           fmt::format("{} x {}", camera.width, camera.height));
  scaled.fx *= scale;
  scaled.fy *= scale;
  scaled.cx = (camera.cx + 0.5) * scale - 0.5;
  scaled.cy = (camera.cy + 0.5) * scale - 0.5;
  return scaled;
}

}  // namespace graspdb
