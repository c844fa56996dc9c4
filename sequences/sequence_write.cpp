// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <mutex>
#include <nlohmann/json.hpp>
#include <sstream>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/parallel.h"
#include "graspdb/renderer/image_io.h"
#include "graspdb/sequences/noise.h"
#include "graspdb/sequences/sequence.h"

namespace graspdb {
namespace {

using nlohmann::json;

template <typename Matrix>
json numbers(const Matrix& matrix) {  // row by row
  json list = json::array();
  for (int row = 0; row < matrix.rows(); ++row) {
    for (int column = 0; column < matrix.cols(); ++column) list.push_back(matrix(row, column));
  }
  return list;
}

template <typename Matrix>
void read_numbers(const json& list, Matrix& matrix) {
  if (list.size() != static_cast<std::size_t>(matrix.size()))
    throw json::out_of_range::create(401, "wrong count", nullptr);
  std::size_t next = 0;
  for (int row = 0; row < matrix.rows(); ++row) {
    for (int column = 0; column < matrix.cols(); ++column)
      matrix(row, column) = list.at(next++).get<double>();
  }
}

json to_json(const FrameTruth& truth, std::size_t frame, double occlusion) {
  return {{"frame", frame},
          {"time_s", truth.time},
          {"closure", truth.closure},
          {"occlusion", occlusion},
          {"camera_from_hand", numbers(truth.camera_from_hand.rotation)},
          {"wrist_m", numbers(truth.camera_from_hand.translation)},
          {"angles", numbers(truth.angles)},
          {"joints_m", numbers(Eigen::MatrixXd(truth.joints.transpose()))}};
}

FrameTruth truth_from_json(const json& line) {
  FrameTruth truth;
  truth.time = line.at("time_s").get<double>();
  truth.closure = line.at("closure").get<double>();
  read_numbers(line.at("camera_from_hand"), truth.camera_from_hand.rotation);
  read_numbers(line.at("wrist_m"), truth.camera_from_hand.translation);
  read_numbers(line.at("angles"), truth.angles);
  Eigen::Matrix<double, kKeypointCount, 3> joints;
  read_numbers(line.at("joints_m"), joints);
  truth.joints = joints.transpose();
  return truth;
}

json describe_sequence(const SequenceRenderer& renderer, const SequenceNoise& noise) {
  const SequenceSpec& spec = renderer.spec();
  const Intrinsics& camera = spec.camera;
  return {{"name", spec.name},
          {"frames_per_second", spec.frames_per_second},
          {"camera",
           {{"width_px", camera.width},
            {"height_px", camera.height},
            {"fx_px", camera.fx},
            {"fy_px", camera.fy},
            {"cx_px", camera.cx},
            {"cy_px", camera.cy}}},
          {"hand", renderer.hand().name},
          {"grasp", spec.grasp.name},
          {"grasp_type", spec.grasp_type ? json(*spec.grasp_type) : json()},
          {"object", spec.object_visible ? spec.grasp.object_name : "none"},
          {"noise", {{"alpha_percent", noise.alpha_percent}, {"seed", noise.seed}}}};
}

// Removes what an earlier, perhaps longer, sequence left there. Without sequence.json an unfinished
// folder is not taken for a sequence.
void prepare_folder(const std::filesystem::path& directory) {
  for (const char* file : {"sequence.json", "truth.jsonl"})
    std::filesystem::remove(directory / file);
  for (const char* name : {"frames", "masks", "noisy"}) {
    const std::filesystem::path folder = directory / name;
    std::filesystem::create_directories(folder);
    std::vector<std::filesystem::path> stale;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() == ".png") stale.push_back(entry.path());
    }
    for (const auto& file : stale) std::filesystem::remove(file);
  }
}

void check_positive(const std::filesystem::path& file, const char* key, double value) {
  if (value > 0) return;
  throw Error({file.string(), key, "more than 0", fmt::format("{}", value)});
}

void check_header(const WrittenSequence& sequence, const std::filesystem::path& file) {
  check_positive(file, "frames_per_second", sequence.frames_per_second);
  check_positive(file, "camera.width_px", sequence.camera.width);
  check_positive(file, "camera.height_px", sequence.camera.height);
  check_positive(file, "camera.fx_px", sequence.camera.fx);
  check_positive(file, "camera.fy_px", sequence.camera.fy);
}

}  // namespace

void write_sequence(const SequenceRenderer& renderer, const std::filesystem::path& directory,
                    const SequenceNoise& noise, const Progress& progress) {
  const auto count = static_cast<std::size_t>(renderer.spec().frame_count());
  std::mutex mutex;
  std::size_t done = 0;
  prepare_folder(directory);
  std::vector<double> occlusion(count);
  parallel_for(count, 0, [&](std::size_t i) {
    const SequenceFrame frame = renderer.render(static_cast<int>(i));
    const std::string name = fmt::format("{:06}.png", i);
    write_png(directory / "frames" / name, frame.color);
    write_png(directory / "masks" / name, frame.hand);
    write_png(directory / "noisy" / name,
              add_segmentation_noise(frame.hand, noise.alpha_percent, noise.seed, i));
    occlusion[i] = frame.occlusion;
    const std::lock_guard lock(mutex);
    if (progress) progress(++done, count);
  });
  std::string lines;
  for (std::size_t i = 0; i < count; ++i) {
    lines += to_json(renderer.truth(static_cast<int>(i)), i, occlusion[i]).dump() + "\n";
  }
  write_text(directory / "truth.jsonl", lines);
  write_text(directory / "sequence.json", describe_sequence(renderer, noise).dump(1) + "\n");
}

WrittenSequence read_sequence(const std::filesystem::path& directory) {
  WrittenSequence sequence{.directory = directory};
  auto file = directory / "sequence.json";
  try {
    const json header = json::parse(read_text(file));
    const json& camera = header.at("camera");
    sequence.camera = {camera.at("width_px"), camera.at("height_px"), camera.at("fx_px"),
                       camera.at("fy_px"),    camera.at("cx_px"),     camera.at("cy_px")};
    sequence.frames_per_second = header.at("frames_per_second").get<double>();
    check_header(sequence, file);
    file = directory / "truth.jsonl";
    std::istringstream lines(read_text(file));
    for (std::string line; std::getline(lines, line);) {
      sequence.truth.push_back(truth_from_json(json::parse(line)));
    }
  } catch (const json::exception& fault) {
    throw Error({file.string(), "", "what `graspdb sequence` writes", fault.what()});
  }
  return sequence;
}

}  // namespace graspdb
