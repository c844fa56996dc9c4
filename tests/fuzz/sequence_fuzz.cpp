// SPDX-License-Identifier: MIT
// Whatever a sequence file holds: it has frames and the times of its keyframes rise, or an Error
// refuses it.
#include <algorithm>
#include <cstdlib>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/sequences/sequence.h"
#include "memory_file.h"
#include "named_file.h"

namespace graspdb {
namespace {

// Every grasp that the project's sequences name is the ball's, which is quickly read.
void write_grasps() {
  const std::filesystem::path sequences = data_directory() / "sequences";
  const std::string ball = read_text(sequences / "test/ball.grasp.toml");
  for (const char* folder : {"test", "train"}) {
    for (const auto& entry : std::filesystem::directory_iterator(sequences / folder)) {
      const std::string name = entry.path().filename().string();
      if (name.ends_with(".grasp.toml")) testing::named_file(name, ball);
    }
  }
}

bool is_sound(const SequenceSpec& spec) {
  const auto is_finite = [](const Keyframe& key) {
    return key.view.allFinite() && key.palm.allFinite() && key.wrist.allFinite() &&
           key.towards_light.allFinite();
  };
  return spec.frame_count() >= 1 && spec.camera.fx > 0 &&
         std::ranges::all_of(spec.keyframes, is_finite) &&
         std::ranges::is_sorted(spec.keyframes, std::less_equal(), &Keyframe::time);
}

}  // namespace
}  // namespace graspdb

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  graspdb::write_grasps();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file =
      graspdb::testing::named_file("fuzz.seq.toml", graspdb::testing::text_of(data, size));
  try {
    if (!graspdb::is_sound(graspdb::load_sequence(file))) std::abort();
  } catch (const graspdb::Error&) {
  }
  return 0;
}
