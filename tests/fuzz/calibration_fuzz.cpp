// SPDX-License-Identifier: MIT
// Whatever a file of a camera's calibration holds: it gives a camera, or an Error refuses it.
#include <cmath>
#include <cstdlib>

#include "graspdb/core/error.h"
#include "graspdb/video/calibration.h"
#include "memory_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const graspdb::testing::MemoryFile file(graspdb::testing::text_of(data, size));
  try {
    const graspdb::Intrinsics camera = graspdb::read_calibration(file.path()).camera;
    if (!(camera.fx > 0) || !std::isfinite(camera.cx) || camera.width < 0) std::abort();
  } catch (const graspdb::Error&) {
  }
  return 0;
}
