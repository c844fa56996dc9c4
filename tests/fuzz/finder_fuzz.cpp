// SPDX-License-Identifier: MIT
// Whatever a file of a finder's weights holds: it looks at frames, or an Error refuses it.
#include <cstdlib>

#include "graspdb/core/error.h"
#include "graspdb/features/hand_finder.h"
#include "memory_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  graspdb::ColorImage frame(23, 17);
  std::uint8_t value = 0;
  for (graspdb::Bgr& pixel : frame) pixel = {value += 37, value += 37, value += 37};
  try {
    const auto finder =
        graspdb::HandFinder::parse(std::string(graspdb::testing::text_of(data, size)), "weights");
    const graspdb::FrameParts parts = finder.look(frame, {1, 2, 21, 15});
    if (parts.cell_px * parts.hand.width() < 21) std::abort();
    finder.find(frame);
  } catch (const graspdb::Error&) {
  }
  return 0;
}
