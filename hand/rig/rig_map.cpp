// SPDX-License-Identifier: MIT
#include "rig_map.h"

#include <fmt/format.h>

#include <algorithm>

#include "graspdb/core/toml.h"
#include "graspdb/hand/digits.h"

namespace graspdb {
namespace {

constexpr double kLargestCoordinate = 1e6;

Eigen::Vector3d read_direction(const TomlTable& table, std::string_view key) {
  const Eigen::Vector3d direction = table.vector3(key, -kLargestCoordinate, kLargestCoordinate);
  if (!(direction.norm() > 1e-6)) table.fail(key, "a direction", "a vector of length 0");
  return direction.normalized();
}

bool is_finger_metacarpal(int bone) {
  return bone >= kFirstFingerBone && bone_parent(bone) == kPalm;
}

PerBone<std::vector<std::string>> read_bones(const TomlTable& table) {
  PerBone<std::vector<std::string>> bones;
  for (int bone = 0; bone < kBoneCount; ++bone) {
    const bool may_be_absent = bone == kForearm || is_finger_metacarpal(bone);
    if (may_be_absent && !table.has(bone_name(bone))) continue;
    std::vector<std::string>& names = bones[static_cast<std::size_t>(bone)];
    names = table.strings(bone_name(bone));
    if (names.empty()) table.fail(bone_name(bone), "at least one bone of the file", "none");
  }
  table.finish();
  return bones;
}

TipPlace read_tip(const TomlTable& table, std::string_view digit) {
  const std::string position = fmt::format("{}_position", digit);
  const std::string beyond = fmt::format("{}_beyond_distal_mm", digit);
  const int given = table.has(digit) + table.has(position) + table.has(beyond);
  if (given > 1) {
    table.fail(digit, fmt::format("one of {}, {}, {}", digit, position, beyond),
               fmt::format("{} of them", given));
  }
  if (table.has(digit)) return table.string(digit);
  if (table.has(position)) {
    return table.vector3(position, -kLargestCoordinate, kLargestCoordinate);
  }
  if (table.has(beyond)) return table.number(beyond, 3, 60) / 1000;
  return std::monostate();
}

void read_tips(const TomlTable& table, RigMap& map) {
  for (int digit = 0; digit < kDigitCount; ++digit)
    map.tips[static_cast<std::size_t>(digit)] = read_tip(table, digit_name(digit));
  table.finish();
}

void index_names(const TomlTable& table, RigMap& map) {
  for (int bone = 0; bone < kBoneCount; ++bone) {
    for (const std::string& name : map.bones[static_cast<std::size_t>(bone)]) {
      if (map.bone_of_name.emplace(name, bone).second) continue;
      table.fail(bone_key(bone), "every bone once", fmt::format("\"{}\" twice", name));
    }
  }
  for (int digit = 0; digit < kDigitCount; ++digit) {
    const auto* name = std::get_if<std::string>(&map.tips[static_cast<std::size_t>(digit)]);
    if (name == nullptr) continue;
    // The skin of a distal bone and of its tip are one.
    const int distal = distal_bone(digit);
    const bool is_new = map.bone_of_name.emplace(*name, distal).second;
    const auto& names = map.bones[static_cast<std::size_t>(distal)];
    if (is_new || std::find(names.begin() + 1, names.end(), *name) != names.end()) continue;
    table.fail(tip_key(digit), "a joint of its own", fmt::format("\"{}\" twice", *name));
  }
}

void read_forearm(const TomlTable& root, RigMap& map) {
  const bool has_bone = !map.bones[kForearm].empty();
  const std::optional<TomlTable> table = root.table_if_any("forearm");
  if (!table && has_bone) return;
  if (!table) {
    root.fail("forearm", fmt::format("a table with a rule, or a bone in {}", bone_key(kForearm)),
              "neither");
  }
  if (!has_bone) {
    map.forearm_split = {.at = table->number("split_at_mm", -50, 100) / 1000,
                         .width = table->number("split_width_mm", 1, 150) / 1000};
  } else if (table->has("split_at_mm") || table->has("split_width_mm")) {
    table->fail("split_at_mm", "a hand without a bone of the forearm",
                fmt::format("one in {}", bone_key(kForearm)));
  }
  map.forearm_extension = table->number_or("extend_mm", 0, 0, 400) / 1000;
  table->finish();
}

void read_corrections(const TomlTable& table, RigMap& map) {
  for (int bone = 0; bone < kBoneCount; ++bone) {
    const std::string key = fmt::format("{}_mm", bone_name(bone));
    if (bone == kForearm || !table.has(key)) continue;
    if (map.bones[static_cast<std::size_t>(bone)].empty()) {
      table.fail(key, "a bone that has a joint", fmt::format("no {}", bone_key(bone)));
    }
    map.moved_along[static_cast<std::size_t>(bone)] = table.number(key, -40, 40) / 1000;
  }
  for (int finger = 0; finger < kFingerCount; ++finger) {
    const std::string key = fmt::format("{}_roll_deg", finger_name(finger));
    map.finger_rolls[static_cast<std::size_t>(finger)] = radians(table.number_or(key, 0, -90, 90));
  }
  table.finish();
}

void read_skin(const TomlTable& table, RigMap& map) {
  if (table.has("longest_edge_mm")) {
    map.longest_edge = table.number("longest_edge_mm", 2, 50) / 1000;
  }
  map.bind_half_bent = table.boolean_or("bind_half_bent", false);
  table.finish();
}

}  // namespace

RigMap load_rig_map(const std::filesystem::path& path) {
  const TomlTable table = TomlTable::load(path);
  RigMap map{.file = table.file(),
             .origin = table.string_or("origin", ""),
             .license = table.string_or("licence", ""),
             .is_left = table.choice("handedness", {"left", "right"}) == "left",
             .meters_per_unit = table.number_or("metres_per_unit", 1, 1e-6, 1e3),
             .thumb_nail = read_direction(table, "thumb_nail"),
             .bones = read_bones(table.table("bones"))};
  if (const auto tips = table.table_if_any("tips")) read_tips(*tips, map);
  index_names(table, map);
  read_forearm(table, map);
  if (const auto corrections = table.table_if_any("corrections")) {
    read_corrections(*corrections, map);
  }
  if (const auto skin = table.table_if_any("skin")) read_skin(*skin, map);
  table.finish();
  return map;
}

std::string bone_key(int bone) {
  return fmt::format("bones.{}", bone_name(bone));
}

std::string tip_key(int digit) {
  return fmt::format("tips.{}", digit_name(digit));
}

}  // namespace graspdb
