// SPDX-License-Identifier: MIT
// Whatever a file of closed poses holds: every pose is finite and has its grasp's hash, or an Error
// refuses it.
#include <cstdlib>

#include "graspdb/core/error.h"
#include "graspdb/grasps/closing.h"
#include "memory_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const graspdb::testing::MemoryFile file(graspdb::testing::text_of(data, size));
  try {
    const graspdb::ClosedPoses closed = graspdb::load_closed_poses(file.path());
    if (!(closed.hand_length > 0)) std::abort();
    for (const auto& [id, pose] : closed.poses) {
      const graspdb::RigidTransform& placed = pose.hand_from_object;
      if (!closed.grasp_hashes.contains(id) || !pose.angles.allFinite() ||
          !placed.translation.allFinite() || !placed.rotation.isUnitary(1e-9)) {
        std::abort();
      }
    }
  } catch (const graspdb::Error&) {
  }
  return 0;
}
