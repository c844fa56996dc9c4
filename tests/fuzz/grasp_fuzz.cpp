// SPDX-License-Identifier: MIT
// Whatever a grasp file holds: it gives a grasp with a finite pose, or an Error refuses it.
#include <cstdlib>

#include "graspdb/core/error.h"
#include "graspdb/grasps/grasp.h"
#include "memory_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const graspdb::testing::MemoryFile file(graspdb::testing::text_of(data, size));
  try {
    const graspdb::Grasp grasp = graspdb::load_grasp(file.path());
    const graspdb::GraspPose& start = grasp.start;
    if (!start.angles.allFinite() || !start.hand_from_object.rotation.allFinite() ||
        !start.hand_from_object.translation.allFinite() || !grasp.approach.allFinite()) {
      std::abort();
    }
  } catch (const graspdb::Error&) {
  }
  return 0;
}
