// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>

#include "crossing.h"
#include "graspdb/core/error.h"
#include "graspdb/core/transform.h"
#include "graspdb/grasps/closing.h"
#include "pose_measures.h"
#include "skin_samples.h"

namespace graspdb {
namespace {

constexpr double kGateMm = 2;
constexpr double kCrossingMm = 0.2;
constexpr double kRangeSlack = 1e-6;  // radians: closed poses are written to 1e-6 degrees

using Gaps = std::array<double, kPalmAndDigitCount>;

std::string_view name_of(int digit) {
  return palm_or_digit_name(digit);
}

bool is_in(int digit, const std::vector<int>& digits) {
  return std::find(digits.begin(), digits.end(), digit) != digits.end();
}

template <typename... Args>
void fail(GraspCheck& check, fmt::format_string<Args...> format, Args&&... args) {
  check.failures.push_back(fmt::format(format, std::forward<Args>(args)...));
}

void check_contacts(const Grasp& grasp, const Gaps& gap_mm, GraspCheck& check) {
  for (const int digit : grasp.required_digits) {
    const double gap = gap_mm[static_cast<std::size_t>(digit)];
    if (gap <= kContactMm) continue;
    fail(check, "{} must touch but is {:.1f} mm from the object (gate {} mm)", name_of(digit), gap,
         kContactMm);
  }
  for (const int digit : grasp.free_digits) {
    const double gap = gap_mm[static_cast<std::size_t>(digit)];
    if (gap > kContactMm) continue;
    fail(check, "{} must stay free but is {:.1f} mm from the object (gate {} mm)", name_of(digit),
         gap, kContactMm);
  }
}

bool is_side(const ContactArea& area) {
  return area.side != SkinSide::kPalmar;
}

// A side grasp is one by the side of the digit that touches.
void check_sides(const Grasp& grasp, const Hand& hand, const GraspPose& closed, GraspCheck& check) {
  if (grasp.opposition != Opposition::kSide) return;
  const SkinSamples skin(hand, 1);
  const auto positions = skin.pose(hand_from_bones(hand.skeleton, closed.angles));
  const RigidTransform object_from_hand = closed.hand_from_object.inverse();
  for (const int digit : grasp.required_digits) {
    double gap = std::numeric_limits<double>::infinity();
    std::string names;
    for (const ContactArea& area : grasp.contacts) {
      if (area.digit != digit || !is_side(area)) continue;
      names += (names.empty() ? "" : ", ") + area.name;
      for (const int i : skin.in_area(area)) {
        const Eigen::Vector3d& at = positions[static_cast<std::size_t>(i)];
        gap = std::min(gap, grasp.object->distance(object_from_hand * at) * kMillimetersPerMeter);
      }
    }
    if (names.empty() || gap <= kContactMm) continue;
    fail(check, "{} must touch with its side ({}), which is {:.1f} mm from the object (gate {} mm)",
         name_of(digit), names, gap, kContactMm);
  }
}

// The digits that hold the object, beside those that the taxonomy lets hold it. With the palm as
// one side of the grasp, palm and thumb may help.
void compare_virtual_fingers(const Grasp& grasp, const Gaps& gap_mm, GraspCheck& check) {
  std::vector<int> named;
  for (const std::vector<int>& finger : grasp.virtual_fingers) {
    named.insert(named.end(), finger.begin(), finger.end());
  }
  for (int digit = 0; digit < kPalmAndDigitCount; ++digit) {
    const bool touches = gap_mm[static_cast<std::size_t>(digit)] <= kContactMm;
    const bool may_help = grasp.opposition == Opposition::kPalm && digit <= 1;
    if (is_in(digit, named) && !touches) check.missing_digits.emplace_back(name_of(digit));
    if (!is_in(digit, named) && touches && !may_help) {
      check.extra_digits.emplace_back(name_of(digit));
    }
  }
}

void check_ranges(const JointAngles& angles, GraspCheck& check) {
  const JointAngles clamped = clamp_to_range(angles);
  for (int i = 0; i < kAngleCount; ++i) {
    if (std::abs(angles[i] - clamped[i]) <= kRangeSlack) continue;
    fail(check, "{} is {:.1f} degrees, beyond its limit of {:.1f}", angle_info(i).name,
         degrees(angles[i]), degrees(clamped[i]));
  }
}

void check_step(const StepCheck& step, GraspCheck& check) {
  if (step.penetration_mm > kGateMm) {
    fail(check, "step {}: hand and object overlap by {:.1f} mm (gate {} mm)", step.step,
         step.penetration_mm, kGateMm);
  }
  if (step.crossing_mm > kCrossingMm) {
    fail(check, "step {}: {:.1f} mm of {} are on the wrong side of the object (gate {} mm)",
         step.step, step.crossing_mm, fmt::join(step.crossed, ", "), kCrossingMm);
  }
  if (step.self_penetration_mm > kGateMm) {
    fail(check, "step {}: digits overlap by {:.1f} mm (gate {} mm)", step.step,
         step.self_penetration_mm, kGateMm);
  }
  if (step.step == 1 && step.clearance_mm <= 0) {
    fail(check, "step 1: the hand must be clear of the object but touches it");
  }
}

// What has crossed the object, here or since the step before.
void add_crossings(const CrossingDepths& here, const CrossingDepths& on_the_way, StepCheck& step) {
  for (std::size_t digit = 0; digit < kPalmAndDigitCount; ++digit) {
    const double depth_mm = std::max(here[digit], on_the_way[digit]) * kMillimetersPerMeter;
    if (depth_mm > kCrossingMm) step.crossed.emplace_back(kPalmAndDigitNames[digit]);
    step.crossing_mm = std::max(step.crossing_mm, depth_mm);
  }
}

}  // namespace

GraspCheck check_grasp(const Grasp& stated, const Hand& hand, const JointAngles& rest,
                       const GraspPose& closed) {
  const Grasp grasp = fitted_to(hand, stated);
  const PoseMeasures measures(hand);
  GraspCheck check;
  for (int number = 1; number <= kStepCount; ++number) {
    auto [step, crossed, gap_mm] =
        measures.measure(grasp, pose_at_step(grasp, rest, closed, number));
    step.step = number;
    CrossingDepths on_the_way{};
    if (number > 1) {
      on_the_way = crossed_on_the_way(grasp, hand, rest, closed, number, measures.digit());
    }
    add_crossings(crossed, on_the_way, step);
    check_step(step, check);
    check.steps.push_back(std::move(step));
    if (number < kStepCount) continue;
    check_contacts(grasp, gap_mm, check);
    compare_virtual_fingers(grasp, gap_mm, check);
  }
  check_sides(grasp, hand, closed, check);
  check_ranges(closed.angles, check);
  check.pass = check.failures.empty();
  return check;
}

}  // namespace graspdb
