// SPDX-License-Identifier: MIT
#include "graspdb/video/calibration.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <opencv2/core.hpp>
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

cv::FileNode first_of(const cv::FileStorage& storage, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (cv::FileNode node = storage[name]; !node.empty()) return node;
  }
  return {};
}

// Of a matrix row by row, or a list; none for an entry that is not there.
std::vector<double> numbers_of(const cv::FileNode& node, const fs::path& file) {
  if (node.empty()) return {};
  cv::Mat matrix;
  if (node.isMap()) node >> matrix;
  if (node.isSeq()) {
    std::vector<double> list;
    node >> list;
    return list;
  }
  if (matrix.empty() || matrix.channels() != 1)
    refuse(file, node.name(), "a matrix of numbers", "something else");
  matrix.convertTo(matrix, CV_64F);
  return {matrix.begin<double>(), matrix.end<double>()};
}

// 0 for an entry that is not there.
int side_of(const cv::FileNode& node, const fs::path& file) {
  if (!node.empty() && !node.isInt()) refuse(file, node.name(), "a whole number", "something else");
  return node.empty() ? 0 : static_cast<int>(node);
}

CameraCalibration read_opencv(const std::string& text, const fs::path& file) {
  const cv::FileStorage storage(text, cv::FileStorage::READ | cv::FileStorage::MEMORY);
  const std::vector<double> matrix =
      numbers_of(first_of(storage, {"camera_matrix", "Camera_Matrix", "cameraMatrix", "K"}), file);
  if (matrix.size() != 9)
    refuse(file, "camera_matrix", "a matrix of 3 x 3", fmt::format("{} numbers", matrix.size()));
  CameraCalibration read = of_matrix(matrix, file);
  read.camera.width = side_of(first_of(storage, {"image_width", "image_Width"}), file);
  read.camera.height = side_of(first_of(storage, {"image_height", "image_Height"}), file);
  const std::vector<double> bends = numbers_of(
      first_of(storage, {"distortion_coefficients", "Distortion_Coefficients", "distCoeffs", "D"}),
      file);
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

bool is_opencv(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  return text.starts_with("%YAML") ||
         (first != std::string::npos && (text[first] == '<' || text[first] == '{'));
}

}  // namespace

CameraCalibration read_calibration(const fs::path& file) {
  const std::string text = read_text(file);
  if (text.size() > kMostBytes)
    refuse(file, "", "a calibration of at most 1 MiB", fmt::format("{} bytes", text.size()));
  if (!is_opencv(text)) return checked(read_plain(text, file), file);
  try {
    return checked(read_opencv(text, file), file);
  } catch (const cv::Exception& error) {
    refuse(file, "", "a calibration of OpenCV", error.err);
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
