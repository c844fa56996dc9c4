// SPDX-License-Identifier: MIT
#include "rig_map.h"

#include "graspdb/text.h"

namespace graspdb {
namespace {

bool read_is_left(const TomlTable& table) {
  const std::string side = table.string("handedness");
  if (side != "left" && side != "right") {
    table.fail("handedness", "\"left\" or \"right\"", "\"" + side + "\"");
  }
  return side == "left";
}

Eigen::Vector3d read_direction(const TomlTable& table, std::string_view key) {
  const std::vector<double> v = table.numbers(key, 3, -1e6, 1e6);
  const Eigen::Vector3d direction(v[0], v[1], v[2]);
  if (!(direction.norm() > 1e-6)) table.fail(key, "a direction", "a vector of length 0");
  return direction.normalized();
}

PerBone<std::vector<std::string>> read_bones(const TomlTable& table) {
  PerBone<std::vector<std::string>> bones;
  for (int bone = 0; bone < kBoneCount; ++bone) {
    std::vector<std::string>& names = bones[static_cast<std::size_t>(bone)];
    names = table.strings(bone_name(bone));
    if (names.empty()) table.fail(bone_name(bone), "at least one bone of the file", "none");
  }
  table.finish();
  return bones;
}

std::array<std::string, 5> read_tips(const TomlTable& table) {
  std::array<std::string, 5> tips = {table.string("thumb"), table.string("index"),
                                     table.string("middle"), table.string("ring"),
                                     table.string("little")};
  table.finish();
  return tips;
}

}  // namespace

RigMap load_rig_map(const std::filesystem::path& path) {
  const TomlTable table = TomlTable::load(path);
  RigMap map{.file = table.file(),
             .is_left = read_is_left(table),
             .metres_per_unit = table.number_or("metres_per_unit", 1, 1e-6, 1e3),
             .thumb_nail = read_direction(table, "thumb_nail"),
             .bones = read_bones(table.table("bones")),
             .tips = read_tips(table.table("tips"))};
  table.finish();
  return map;
}

}  // namespace graspdb
