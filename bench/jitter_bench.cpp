// SPDX-License-Identifier: MIT
// The table of docs/jitter.md: how far a hand whose angles were varied after it had closed is in
// its object, for each amplitude in degrees that is given.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "graspdb/closing.h"
#include "graspdb/file.h"
#include "graspdb/parallel.h"
#include "graspdb/rig.h"
#include "jitter.h"

namespace graspdb {
namespace {

constexpr std::size_t kDraws = 6;

struct Grasps {
  Hand hand = load_hand(data_directory() / "assets/hands/male.glb");
  std::vector<Grasp> all = load_grasps(data_directory() / "grasps");
  JointAngles rest = load_rest_pose(data_directory() / "grasps");
};

std::string median_p95_most(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return fmt::format("{:.1f}, {:.1f}, {:.1f}", values[values.size() / 2],
                     values[values.size() * 95 / 100], values.back());
}

void print(const Grasps& grasps, double angles_deg) {
  const std::size_t count = grasps.all.size() * kDraws;
  std::vector<double> in_object(count), in_digits(count);
  std::vector<std::uint8_t> loose(count);
  parallel_for(count, 0, [&](std::size_t i) {
    const Grasp& grasp = grasps.all[i / kDraws];
    GraspPose closed = closed_pose(grasp, grasps.hand);
    const int copy = static_cast<int>(i % kDraws) + 1;
    const JitterDraw draw({.angles_deg = angles_deg}, grasps.hand.name, grasp.id, copy);
    closed.angles = draw.angles(closed.angles);
    const GraspCheck check = check_grasp(grasp, grasps.hand, grasps.rest, closed);
    in_object[i] = check.steps.back().penetration_mm;
    in_digits[i] = check.steps.back().self_penetration_mm;
    loose[i] = check.missing_digits.empty() ? 0 : 1;
  });
  const auto misses = static_cast<std::size_t>(std::count(loose.begin(), loose.end(), 1));
  fmt::print("| {:g} degrees | {} | {} | {} % |\n", angles_deg, median_p95_most(in_object),
             median_p95_most(in_digits), 100 * misses / count);
  std::fflush(stdout);
}

}  // namespace
}  // namespace graspdb

int main(int count, char** amplitudes) {
  const graspdb::Grasps grasps;
  for (int i = 1; i < count; ++i) graspdb::print(grasps, std::strtod(amplitudes[i], nullptr));
}
