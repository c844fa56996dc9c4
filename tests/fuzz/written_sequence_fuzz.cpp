// SPDX-License-Identifier: MIT
// Whatever sequence.json and truth.jsonl hold: the camera has pixels and every frame is finite, or
// an Error refuses them. An input is both files, with a line "===" between them.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "graspdb/core/error.h"
#include "graspdb/sequences/sequence.h"
#include "memory_file.h"
#include "named_file.h"

namespace graspdb {
namespace {

bool is_sound(const FrameTruth& truth) {
  return std::isfinite(truth.time) && std::isfinite(truth.closure) && truth.angles.allFinite() &&
         truth.joints.allFinite() && truth.camera_from_hand.rotation.allFinite() &&
         truth.camera_from_hand.translation.allFinite();
}

bool is_sound(const WrittenSequence& sequence) {
  const Intrinsics& camera = sequence.camera;
  return camera.width > 0 && camera.height > 0 && camera.fx > 0 && camera.fy > 0 &&
         sequence.frames_per_second > 0 &&
         std::ranges::all_of(sequence.truth, [](const FrameTruth& t) { return is_sound(t); });
}

}  // namespace
}  // namespace graspdb

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::string_view kBetween = "===\n";
  const std::string_view bytes = graspdb::testing::text_of(data, size);
  const std::size_t end = std::min(bytes.find(kBetween), bytes.size());
  graspdb::testing::named_file("sequence.json", bytes.substr(0, end));
  graspdb::testing::named_file("truth.jsonl",
                               bytes.substr(std::min(end + kBetween.size(), bytes.size())));
  try {
    if (!graspdb::is_sound(graspdb::read_sequence(graspdb::testing::own_folder()))) std::abort();
  } catch (const graspdb::Error&) {
  }
  return 0;
}
