// SPDX-License-Identifier: MIT
// Whatever a rig map holds: every bone has a name and the nail a direction, or an Error refuses it.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "graspdb/error.h"
#include "memory_file.h"
#include "rig_map.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const graspdb::testing::MemoryFile file(graspdb::testing::text_of(data, size));
  try {
    const graspdb::RigMap map = graspdb::load_rig_map(file.path());
    const bool named = std::ranges::none_of(map.bones, [](const auto& b) { return b.empty(); });
    if (!named || std::abs(map.thumb_nail.norm() - 1) > 1e-9) std::abort();
  } catch (const graspdb::Error&) {
  }
  return 0;
}
