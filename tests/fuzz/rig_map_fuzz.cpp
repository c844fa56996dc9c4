// SPDX-License-Identifier: MIT
// Whatever a rig map holds: every bone has a name or a rule, all numbers are finite and the nail
// has a direction, or an Error refuses it.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "graspdb/core/error.h"
#include "memory_file.h"
#include "rig_map.h"

namespace graspdb {
namespace {

bool may_be_absent(int bone) {
  return bone == kForearm || (bone >= kFirstFingerBone && bone_parent(bone) == kPalm);
}

bool is_sound(const RigMap& map) {
  for (int bone = 0; bone < kBoneCount; ++bone) {
    const auto i = static_cast<std::size_t>(bone);
    if (map.bones[i].empty() && !may_be_absent(bone)) return false;
    if (!std::isfinite(map.moved_along[i])) return false;
  }
  if (map.forearm_split.has_value() != map.bones[kForearm].empty()) return false;
  if (map.longest_edge && !(*map.longest_edge > 0)) return false;
  if (map.forearm_split && !(map.forearm_split->width > 0)) return false;
  return std::ranges::all_of(map.finger_rolls, [](double roll) { return std::isfinite(roll); }) &&
         std::isfinite(map.forearm_extension) && std::abs(map.thumb_nail.norm() - 1) < 1e-9;
}

}  // namespace
}  // namespace graspdb

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const graspdb::testing::MemoryFile file(graspdb::testing::text_of(data, size));
  try {
    const graspdb::RigMap map = graspdb::load_rig_map(file.path());
    if (!graspdb::is_sound(map)) std::abort();
  } catch (const graspdb::Error&) {
  }
  return 0;
}
