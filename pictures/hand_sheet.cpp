// SPDX-License-Identifier: MIT
#include "graspdb/pictures/hand_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "graspdb/hand/named_poses.h"
#include "model_view.h"

namespace graspdb {
namespace {

constexpr int kPoseTile = 260;  // pixels
constexpr int kAngleTile = 150;
constexpr double kShownRadians = radians(20);

ModelView bare(const Hand& hand, const JointAngles& angles) {
  return {hand, {.angles = angles}, nullptr};
}

const Side& telling_side(int angle) {
  switch (angle) {
    case kWristFlexion:
    case kThumbMcpAbduction:
      return sides::kThumb;
    case kWristDeviation:
      return sides::kBack;
    case kThumbCmcAbduction:
      return sides::kFingerTips;
    case kThumbCmcAxial:
    case kThumbCmcFlexion:
    case kThumbMcpFlexion:
    case kThumbIpFlexion:
      return sides::kPalm;
    default:
      break;
  }
  const int finger = (angle - kFirstFingerAngle) / 5, part = (angle - kFirstFingerAngle) % 5;
  if (part == kCmcFlexion) return sides::kFingerTips;
  if (part == kMcpAbduction) return sides::kBack;
  return finger < 2 ? sides::kThumb : sides::kLittleFinger;
}

// The bones that one angle moves.
BoneSet moved_bones(const Hand& hand, const JointAngles& angles) {
  const auto flat = hand_from_bones(hand.skeleton, JointAngles::Zero());
  const auto bent = hand_from_bones(hand.skeleton, angles);
  BoneSet moved;
  for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
    moved[bone] = angle_between(flat[bone].rotation, bent[bone].rotation) > 1e-6;
  }
  return moved;
}

// Both models, without the forearm where only digits move.
Framed shared_frame(const ModelView& flat, const ModelView& bent, bool with_forearm) {
  Framed both;
  for (const ModelView* model : {&flat, &bent}) {
    for (const Eigen::Vector3f& v : model->framed()) {
      if (with_forearm || v.y() > 0) both.push_back(v);
    }
  }
  return both;
}

}  // namespace

ColorImage draw_hand_sheet(const Hand& hand) {
  constexpr int kTitle = 22;
  const std::array<Side, 4> around = {sides::kPalm, sides::kThumb, sides::kBack,
                                      sides::kLittleFinger};
  Page page(kPoseTile * static_cast<int>(around.size()),
            (kPoseTile + kTitle) * static_cast<int>(kNamedPoses.size()));
  int y = 0;
  for (const std::string_view pose : kNamedPoses) {
    const ModelView model = bare(hand, named_pose(pose));
    int x = 0;
    for (const Side& side : around) {
      page.place(model.seen(side, kPoseTile), x, y + kTitle);
      page.write(fmt::format("{}, {}", pose, side.name), x + 8, y + 16);
      x += kPoseTile;
    }
    y += kPoseTile + kTitle;
  }
  return page.image();
}

ColorImage draw_angle_page(const Hand& hand) {
  constexpr int kColumns = 4, kTitle = 22, kWidth = 2 * kAngleTile + 10;
  constexpr int kRows = (kAngleCount + kColumns - 1) / kColumns;
  Page page(kColumns * kWidth, kRows * (kAngleTile + kTitle));
  const ModelView flat = bare(hand, JointAngles::Zero());
  for (int angle = 0; angle < kAngleCount; ++angle) {
    JointAngles angles = JointAngles::Zero();
    angles[angle] = std::min(kShownRadians, angle_info(angle).upper);
    const ModelView bent = bare(hand, angles);
    const Framed both = shared_frame(flat, bent, angle <= kWristDeviation);
    const BoneSet moved = moved_bones(hand, angles);
    const int x = angle % kColumns * kWidth, y = angle / kColumns * (kAngleTile + kTitle);
    const Side& side = telling_side(angle);
    page.place(flat.seen(side, kAngleTile, both, moved), x, y + kTitle);
    page.place(bent.seen(side, kAngleTile, both, moved), x + kAngleTile, y + kTitle);
    page.write(
        fmt::format("{}  {}  {:+.0f} deg", angle, angle_info(angle).name, degrees(angles[angle])),
        x + 6, y + 16);
  }
  return page.image();
}

}  // namespace graspdb
