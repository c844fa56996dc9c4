// SPDX-License-Identifier: MIT
// Whatever a hand's .glb holds: it gives a sound hand under the male hand's rig map, or an Error
// refuses it; and so does the check of hand files.
#include <algorithm>
#include <cstdlib>

#include "glb_mutator.h"
#include "graspdb/core/error.h"
#include "graspdb/hand/check/hand_file_check.h"
#include "graspdb/hand/rig/rig.h"
#include "named_file.h"

namespace graspdb {
namespace {

bool is_sound(const Hand& hand) {
  const Mesh& mesh = hand.bind_mesh;
  const auto is_inside = [&](std::uint32_t vertex) { return vertex < mesh.vertices.size(); };
  return hand.weights.size() == mesh.vertices.size() &&
         std::ranges::all_of(mesh.vertices, [](const auto& v) { return v.allFinite(); }) &&
         std::ranges::all_of(mesh.triangles, [&](const Triangle& triangle) {
           return std::ranges::all_of(triangle, is_inside);
         });
}

void expect_sound_or_refused(const std::filesystem::path& file) {
  static const std::filesystem::path map = rig_map_beside(default_hand_file());
  try {
    if (!is_sound(load_hand(file, map))) std::abort();
  } catch (const Error&) {
  }
}

void expect_checked_or_refused(const std::filesystem::path& file) {
  try {
    if (check_hand_file(file).empty()) std::abort();
    hand_file_generator(file);
  } catch (const Error&) {
  }
}

}  // namespace
}  // namespace graspdb

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = graspdb::testing::named_file("hand.glb", graspdb::testing::text_of(data, size));
  graspdb::expect_sound_or_refused(file);
  graspdb::expect_checked_or_refused(file);
  return 0;
}
