// SPDX-License-Identifier: MIT
// A right hand is one whatever its rest pose, and a wrong word for it is refused with what was
// seen.
#include <gmock/gmock.h>

#include "graspdb/hand/maker/hand_maker.h"
#include "graspdb/hand/named_poses.h"
#include "rig_maps.h"

namespace graspdb {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::kMale;
using testing::TemporaryDirectory;

// All fingers' three joints, and the thumb stretched away from the palm.
JointAngles stretched(double flexion_deg) {
  JointAngles angles = JointAngles::Zero();
  for (int finger = 0; finger < kFingerCount; ++finger) {
    for (const FingerAngle angle : {kMcpFlexion, kPipFlexion, kDipFlexion}) {
      angles[finger_angle(finger, angle)] = radians(flexion_deg);
    }
  }
  angles[kThumbCmcFlexion] = radians(4 * flexion_deg);
  angles[kThumbCmcAbduction] = angles[kThumbIpFlexion] = radians(2 * flexion_deg);
  return angles;
}

Hand resting(const JointAngles& angles) {
  Hand hand = load_hand(kMale);
  const PerBone<RigidTransform> frames = hand_from_bones(hand.skeleton, angles);
  hand.bind_mesh = pose_skin(hand, frames);
  hand.hand_from_bone_at_bind = frames;
  return hand;
}

// The hand as a file that rests as it is bound, stated to be right or left.
Hand reloaded(const Hand& hand, const std::string& handedness) {
  const TemporaryDirectory directory;
  const auto file = directory / "hand.glb";
  write_hand(hand, file);
  const std::string map = read_text(rig_map_beside(file));
  write_text(rig_map_beside(file), testing::replaced(map, "\"right\"", "\"" + handedness + "\""));
  return load_hand(file);
}

// What loading says.
std::string refusal_of(const Hand& hand, const std::string& handedness) {
  try {
    reloaded(hand, handedness);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

class Handedness : public ::testing::TestWithParam<double> {};

TEST_P(Handedness, IsToldByMoreThanTheBendOfFingers) {
  const Hand hand = resting(stretched(GetParam()));
  EXPECT_EQ(refusal_of(hand, "right"), "accepted");
  EXPECT_THAT(refusal_of(hand, "left"),
              AllOf(HasSubstr("'handedness': expected a left hand, found signs of a right one"),
                    HasSubstr("the thumb's root"), HasSubstr("% of the palm's flesh palmar"),
                    HasSubstr("% of the fingertips' flesh palmar")));
}

TEST_P(Handedness, AStretchedHandBendsAsItDidBefore) {
  const Hand hand = load_hand(kMale),
             stretched_hand = reloaded(resting(stretched(GetParam())), "right");
  EXPECT_LT((keypoints_in_hand(stretched_hand.skeleton, named_pose("fist")) -
             keypoints_in_hand(hand.skeleton, named_pose("fist")))
                .cwiseAbs()
                .maxCoeff(),
            1e-6);
}

INSTANTIATE_TEST_SUITE_P(FlexionDeg, Handedness, ::testing::Values(0., -2., -5., -10.));

TEST(Handedness, IsToldInEveryNamedPose) {
  for (const std::string_view pose : kNamedPoses) {
    EXPECT_EQ(refusal_of(resting(named_pose(pose)), "right"), "accepted") << pose;
    EXPECT_THAT(refusal_of(resting(named_pose(pose)), "left"), HasSubstr("'handedness'")) << pose;
  }
}

TEST(Handedness, OneSignAgainstThreeIsOutvoted) {
  // Bent back by 40 degrees at PIP and DIP together, as no hand can.
  EXPECT_EQ(refusal_of(resting(stretched(-20)), "right"), "accepted");
}

TEST(Handedness, SignsThatDisagreeAreNamed) {
  // Its flesh lies on the back of its bones, by which it would be a left hand.
  Hand hand = resting(JointAngles::Zero());
  for (Eigen::Vector3f& v : hand.bind_mesh.vertices) v.z() = -v.z();
  for (Triangle& t : hand.bind_mesh.triangles) std::swap(t[0], t[1]);
  EXPECT_THAT(refusal_of(hand, "right"),
              AllOf(HasSubstr("signs of a left one (24 % of the palm's flesh"),
                    HasSubstr("and of a right one (the thumb's root 8 mm palmar")));
}

}  // namespace
}  // namespace graspdb
