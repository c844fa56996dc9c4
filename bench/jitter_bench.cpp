// SPDX-License-Identifier: MIT
// The figures of docs/jitter.md. `angles 0 2`: how far a hand whose angles were varied by so many
// degrees after it had closed is in its object. `sizes 0.9 1.1`: which grasps pass their check with
// objects that are so many times as large, the hand closed again on them.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "graspdb/core/file.h"
#include "graspdb/core/parallel.h"
#include "graspdb/grasps/closing.h"
#include "graspdb/hand/rig/rig.h"
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

void print_angles(const Grasps& grasps, double angles_deg) {
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

void print_sizes(const Grasps& grasps, double factor) {
  std::vector<GraspCheck> checks(grasps.all.size());
  parallel_for(checks.size(), 0, [&](std::size_t i) {
    Grasp grasp = grasps.all[i];
    grasp.object = scaled(grasp.object, factor);
    const GraspPose closed = close_grasp(grasp, grasps.hand);
    checks[i] = check_grasp(grasp, grasps.hand, grasps.rest, closed);
  });
  const auto passed = std::count_if(checks.begin(), checks.end(),
                                    [](const GraspCheck& check) { return check.pass; });
  fmt::print("size {:g}: {} of {} pass\n", factor, passed, checks.size());
  for (std::size_t i = 0; i < checks.size(); ++i) {
    for (const std::string& failure : checks[i].failures)
      fmt::print("  {} {}: {}\n", grasps.all[i].id, grasps.all[i].name, failure);
  }
  std::fflush(stdout);
}

}  // namespace
}  // namespace graspdb

int main(int count, char** arguments) {
  const graspdb::Grasps grasps;
  const bool sizes = count > 1 && std::string_view(arguments[1]) == "sizes";
  for (int i = 2; i < count; ++i) {
    const double value = std::strtod(arguments[i], nullptr);
    if (sizes) {
      graspdb::print_sizes(grasps, value);
    } else {
      graspdb::print_angles(grasps, value);
    }
  }
}
