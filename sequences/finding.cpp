// SPDX-License-Identifier: MIT
#include "graspdb/sequences/finding.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "graspdb/core/error.h"
#include "graspdb/core/transform.h"
#include "graspdb/features/segmentation.h"

namespace graspdb {
namespace {

constexpr double kArmHalfWidthMm = 60;  // what lies further to the side is not at the wrist
constexpr double kLeastSine = 0.5;      // of the arm to the line of sight
constexpr std::size_t kBeyondEnd = 2;   // percent of the pixels, which are frayed

// The forearm in the picture.
struct ArmLine {
  Eigen::Vector2d wrist_px, proximal;  // of length 1
  double px_per_mm;                    // along the arm
  double px_per_mm_across;
};

std::optional<ArmLine> arm_line(const FrameTruth& frame, const Skeleton& skeleton,
                                const Intrinsics& camera) {
  const RigidTransform& camera_from_hand = frame.camera_from_hand;
  const Eigen::Vector3d wrist = camera_from_hand.translation;
  const Eigen::Vector3d proximal =
      -(camera_from_hand * hand_from_bones(skeleton, frame.angles)[kForearm]).rotation.col(1);
  if (proximal.cross(wrist.normalized()).norm() < kLeastSine) return std::nullopt;
  constexpr double kStepMm = 10;
  const Eigen::Vector2d begin = camera.project(wrist);
  const Eigen::Vector2d end = camera.project(wrist + proximal * kStepMm / kMillimetersPerMeter);
  return ArmLine{begin, (end - begin).normalized(), (end - begin).norm() / kStepMm,
                 camera.fx / wrist.z() / kMillimetersPerMeter};
}

// Millimetres beyond the wrist joint.
std::optional<double> end_of(const Mask& hand, const ArmLine& arm) {
  const Eigen::Vector2d across(-arm.proximal.y(), arm.proximal.x());
  std::vector<double> places;
  for (int y = 0; y < hand.height(); ++y) {
    for (int x = 0; x < hand.width(); ++x) {
      if (hand.at(x, y) == 0) continue;
      const Eigen::Vector2d from_wrist = Eigen::Vector2d(x, y) - arm.wrist_px;
      if (std::abs(across.dot(from_wrist)) > kArmHalfWidthMm * arm.px_per_mm_across) continue;
      places.push_back(arm.proximal.dot(from_wrist) / arm.px_per_mm);
    }
  }
  if (places.empty()) return std::nullopt;
  const auto end = places.end() - 1 - static_cast<std::ptrdiff_t>(places.size() * kBeyondEnd / 100);
  std::nth_element(places.begin(), end, places.end());
  return *end;
}

double wrist_error(const Mask& found, const Mask& truth, const ArmLine& arm) {
  const std::optional<double> found_end = end_of(found, arm), true_end = end_of(truth, arm);
  return found_end && true_end ? std::abs(*found_end - *true_end) : Finding::kNone;
}

}  // namespace

Finding compare_masks(const Mask& found, const Mask& truth, const FrameTruth& frame,
                      const Skeleton& skeleton, const Intrinsics& camera) {
  const bool is_found = !is_empty(found), is_there = !is_empty(truth);
  Finding finding{.iou = mask_iou(found, truth),
                  .missed = is_there && !is_found,
                  .imagined = is_found && !is_there};
  if (!is_found || !is_there) return finding;
  if (const auto arm = arm_line(frame, skeleton, camera))
    finding.wrist_mm = wrist_error(found, truth, *arm);
  return finding;
}

double mask_iou(const Mask& a, const Mask& b) {
  GRASPDB_CHECK(a.width() == b.width() && a.height() == b.height());
  std::size_t both = 0, either = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    both += a.data()[i] != 0 && b.data()[i] != 0;
    either += a.data()[i] != 0 || b.data()[i] != 0;
  }
  return either > 0 ? static_cast<double>(both) / static_cast<double>(either) : std::nan("");
}

}  // namespace graspdb
