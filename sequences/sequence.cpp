// SPDX-License-Identifier: MIT
#include "graspdb/sequences/sequence.h"

#include <algorithm>
#include <cmath>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/toml.h"
#include "graspdb/hand/rig/rig.h"

namespace graspdb {
namespace {

Intrinsics read_camera(const TomlTable& table) {
  Intrinsics camera;
  camera.width = table.integer_or("width_px", 640, 64, 8192);
  camera.height = table.integer_or("height_px", 480, 64, 8192);
  camera.fx = camera.fy = table.number("focal_px", 50, 20000);
  camera.cx = (camera.width - 1) / 2.0;
  camera.cy = (camera.height - 1) / 2.0;
  table.finish();
  return camera;
}

// Either a file, seen from the data directory, or measures that no default hand has.
SequenceHand read_hand(const TomlTable& table) {
  if (table.has("file")) {
    const std::string file = table.string("file");
    table.finish();
    return {.file = data_directory() / file};
  }
  WantedMeasures wanted;
  const MeasureRanges& ranges = kMeasureRanges;
  const auto read = [&](const char* key, std::optional<double>& measure,
                        const MeasureRange& range) {
    measure = table.number(key, range.low, range.high);
  };
  const auto read_if_any = [&](const char* key, std::optional<double>& measure,
                               const MeasureRange& range) {
    if (table.has(key)) read(key, measure, range);
  };
  read("length_mm", wanted.length_mm, ranges.length_mm);
  read("breadth_mm", wanted.breadth_mm, ranges.breadth_mm);
  read_if_any("finger_length_mm", wanted.finger_length_mm, ranges.finger_length_mm);
  read_if_any("finger_breadth_mm", wanted.finger_breadth_mm, ranges.finger_breadth_mm);
  read_if_any("palm_thickness_mm", wanted.palm_thickness_mm, ranges.palm_thickness_mm);
  read_if_any("forearm_breadth_mm", wanted.forearm_breadth_mm, ranges.forearm_breadth_mm);
  wanted.forearm_length_mm =
      table.number_or("forearm_length_mm", 220, 150, ranges.forearm_length_mm.high);
  HandShape shape = in_proportion(default_hand_shape("male"), wanted);
  shape.name = table.string("name");
  table.finish();
  return {.shape = shape};
}

// The light is the one of all keyframes that have none of their own.
Look read_look(const TomlTable& table, Keyframe& otherwise) {
  Look look;
  look.skin_bgr = table.vector3("skin_bgr", 0, 255);
  look.object_bgr = table.vector3("object_bgr", 0, 255);
  look.ambient = table.number_or("ambient", look.ambient, 0, 1);
  look.skin_mottling = table.number_or("skin_mottling", 0, 0, 0.5);
  look.blur_px = table.number_or("blur_px", 0, 0, 10);
  look.sensor_noise = table.number("sensor_noise", 0, 50);
  otherwise.towards_light = table.vector3("towards_light", -1, 1);
  table.finish();
  return look;
}

Keyframe read_keyframe(const TomlTable& table, const Keyframe& otherwise) {
  Keyframe key = otherwise;
  key.time = table.number("time_s", 0, 3600);
  key.closure = table.number("closure", 0, 1);
  key.view = table.vector3("view_deg", -720, 720) * (kPi / 180);
  key.palm = table.vector3("palm_mm", -5000, 5000) / 1000;
  if (table.has("wrist_deg")) {
    const std::vector<double> wrist = table.numbers("wrist_deg", 2, -80, 80);
    key.wrist = Eigen::Vector2d(wrist[0], wrist[1]) * (kPi / 180);
  }
  if (table.has("towards_light")) key.towards_light = table.vector3("towards_light", -1, 1);
  table.finish();
  if (key.palm.z() < 0.1)
    table.fail("palm_mm", "a palm at least 100 mm in front of the camera", "less");
  return key;
}

std::vector<Keyframe> read_keyframes(const TomlTable& table, const Keyframe& otherwise) {
  std::vector<Keyframe> keyframes;
  for (const TomlTable& key : table.tables("keyframe")) {
    keyframes.push_back(read_keyframe(key, otherwise));
    if (keyframes.size() > 1 && keyframes.back().time <= keyframes[keyframes.size() - 2].time) {
      key.fail("time_s", "a later time than the keyframe before", "an earlier one");
    }
  }
  if (keyframes.size() < 2)
    table.fail("keyframe", "at least two", std::to_string(keyframes.size()));
  return keyframes;
}

}  // namespace

int SequenceSpec::frame_count() const {
  const double duration = keyframes.back().time - keyframes.front().time;
  return static_cast<int>(std::floor(duration * frames_per_second + 1e-9)) + 1;
}

std::vector<std::filesystem::path> sequence_files(const std::filesystem::path& given) {
  if (std::filesystem::is_regular_file(given)) return {given};
  std::vector<std::filesystem::path> files;
  if (std::filesystem::is_directory(given)) {
    for (const auto& entry : std::filesystem::directory_iterator(given)) {
      if (entry.path().string().ends_with(".seq.toml")) files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  if (files.empty())
    throw Error({.file = given.string(), .expected = "sequences (*.seq.toml)", .found = "none"});
  return files;
}

SequenceSpec load_sequence(const std::filesystem::path& file,
                           const std::filesystem::path& hand_file) {
  const TomlTable table = TomlTable::load(file);
  SequenceSpec spec;
  spec.file = file;
  spec.name = table.string("name");
  spec.seed = static_cast<std::uint64_t>(table.integer("seed", 0, 1 << 30));
  spec.frames_per_second =
      table.number_or("frames_per_second", 10, kMinFramesPerSecond, kMaxFramesPerSecond);
  spec.visible_forearm = table.number("visible_forearm_mm", 0, 300) / 1000;
  spec.object_visible = table.boolean_or("object_visible", true);
  spec.camera = read_camera(table.table("camera"));
  Keyframe otherwise;
  spec.look = read_look(table.table("look"), otherwise);
  spec.hand = read_hand(table.table("hand"));
  if (!hand_file.empty()) spec.hand = {.file = hand_file};
  spec.grasp = load_grasp(file.parent_path() / table.string("grasp"));
  if (table.has("grasp_type")) spec.grasp_type = table.integer("grasp_type", 1, 33);
  spec.rest = load_rest_pose(file.parent_path());
  spec.keyframes = read_keyframes(table, otherwise);
  table.finish();
  return spec;
}

std::optional<SequenceSpec> with_grasp_of_type(SequenceSpec spec,
                                               const std::filesystem::path& grasps) {
  const std::vector<Grasp> all = load_grasps(grasps);
  const auto same =
      std::ranges::find_if(all, [&](const Grasp& grasp) { return spec.grasp_type == grasp.id; });
  if (same == all.end()) return std::nullopt;
  spec.grasp = *same;
  spec.rest = load_rest_pose(grasps);
  return spec;
}

Hand sequence_hand(const SequenceSpec& spec) {
  return spec.hand.file.empty() ? make_hand(spec.hand.shape) : load_hand(spec.hand.file);
}

}  // namespace graspdb
