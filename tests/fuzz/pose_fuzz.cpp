// SPDX-License-Identifier: MIT
// Whatever a pose file holds: it gives a rotation and finite angles, or an Error refuses it.
#include <cstdlib>

#include "graspdb/core/error.h"
#include "graspdb/pictures/pose_file.h"
#include "memory_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const graspdb::testing::MemoryFile file(graspdb::testing::text_of(data, size));
  try {
    const graspdb::PoseFile pose = graspdb::load_pose(file.path());
    if (!pose.rotation.isUnitary(1e-9) || !pose.angles.allFinite()) std::abort();
  } catch (const graspdb::Error&) {
  }
  return 0;
}
