// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <mutex>
#include <sstream>

#include "graspdb/core/file.h"
#include "graspdb/core/folder.h"
#include "graspdb/core/json/json_numbers.h"
#include "graspdb/core/json/strict_json.h"
#include "graspdb/core/parallel.h"
#include "graspdb/renderer/image_io.h"
#include "graspdb/sequences/noise.h"
#include "graspdb/sequences/sequence.h"

namespace graspdb {
namespace {

using nlohmann::json;

using JointRows = Eigen::Matrix<double, kKeypointCount, 3>;

json to_json(const FrameTruth& truth, std::size_t frame, double occlusion) {
  return {{"frame", frame},
          {"time_s", truth.time},
          {"closure", truth.closure},
          {"occlusion", occlusion},
          {"camera_from_hand", numbers(truth.camera_from_hand.rotation)},
          {"wrist_m", numbers(truth.camera_from_hand.translation)},
          {"angles", numbers(truth.angles)},
          {"joints_m", numbers(truth.joints.transpose())}};
}

FrameTruth read_truth(const JsonFields& line) {
  return {.time = line.number("time_s"),
          .camera_from_hand = {line.matrix<Eigen::Matrix3d>("camera_from_hand"),
                               line.matrix<Eigen::Vector3d>("wrist_m")},
          .angles = line.matrix<JointAngles>("angles"),
          .joints = line.matrix<JointRows>("joints_m").transpose(),
          .closure = line.number("closure")};
}

std::vector<FrameTruth> read_truths(const std::filesystem::path& file) {
  std::vector<FrameTruth> truths;
  std::istringstream lines(read_text(file));
  for (std::string line; std::getline(lines, line);) {
    const std::string key = fmt::format("line {}", truths.size() + 1);
    const json fields = parse_strict_json(line, file.string(), key);
    truths.push_back(read_truth(JsonFields(fields, file.string(), key)));
  }
  return truths;
}

json describe_sequence(const SequenceRenderer& renderer, const SequenceNoise& noise) {
  const SequenceSpec& spec = renderer.spec();
  return {{"name", spec.name},
          {"frames_per_second", spec.frames_per_second},
          {"camera", camera_json(spec.camera)},
          {"hand", renderer.hand().name},
          {"grasp", spec.grasp.name},
          {"grasp_type", spec.grasp_type ? json(*spec.grasp_type) : json()},
          {"object", spec.object_visible ? spec.grasp.object_name : "none"},
          {"noise", {{"alpha_percent", noise.alpha_percent}, {"seed", noise.seed}}}};
}

// Without sequence.json an unfinished folder is not taken for a sequence.
FolderContent sequence_content() {
  const std::string name = digits(6) + ".png";
  return {.kind = "a rendered sequence",
          .marker = ".graspdb-sequence",
          .files = {"frames/" + name, "masks/" + name, "noisy/" + name, "truth.jsonl",
                    "sequence.json"}};
}

}  // namespace

void write_sequence(const SequenceRenderer& renderer, const std::filesystem::path& directory,
                    const SequenceNoise& noise, const Progress& progress) {
  const auto count = static_cast<std::size_t>(renderer.spec().frame_count());
  std::mutex mutex;
  std::size_t done = 0;
  renew_folder(directory, sequence_content());
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
  const auto file = directory / "sequence.json";
  const json root = parse_strict_json(read_text(file), file.string(), "");
  const JsonFields header(root, file.string(), "");
  return {.directory = directory,
          .camera = read_camera(header.fields("camera")),
          .frames_per_second = header.positive("frames_per_second"),
          .truth = read_truths(directory / "truth.jsonl")};
}

}  // namespace graspdb
