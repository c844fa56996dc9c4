// SPDX-License-Identifier: MIT
// What a rig map states is held against the skin: each line passes on the male hand and fails on
// one that was told wrongly.
#include "stated.h"

#include "graspdb/hand/named_poses.h"
#include "spoilt_hands.h"

namespace graspdb::testing {
namespace {

TEST(HandCheckStated, PassesOnAGoodHand) {
  for (const HandCheckLine& line : check_stated(male())) {
    EXPECT_EQ(line.status, Status::kPass) << line.name << " " << line.value << " " << line.why;
  }
}

TEST(HandCheckStated, AThumbsNailThatIsFarOffIsFound) {
  for (const double off : {-90., -60., -47., 47., 60., 90.}) {
    const Hand hand = with_bones_rolled(kThumbMetacarpal, kThumbDistal, radians(off));
    const Lines lines = check_stated(hand);
    expect_fail(lines, "nail, thumb");
    EXPECT_NEAR(line_of(lines, "nail, thumb").value, std::abs(off), 8);
    expect_pass(lines, "nail, fingers");
  }
  expect_pass(check_stated(with_bones_rolled(kThumbMetacarpal, kThumbDistal, radians(10))),
              "nail, thumb");
}

TEST(HandCheckStated, AFingerRolledFarOffIsFound) {
  const int ring = finger_bone(2, kProximal);
  for (const double off : {-47., 47.}) {
    const Lines lines = check_stated(with_bones_rolled(ring, ring + 2, radians(off)));
    expect_fail(lines, "nail, fingers", "ring");
    expect_pass(lines, "nail, thumb");
  }
}

TEST(HandCheckStated, AnEndThatIsRoundTellsNothing) {
  Hand hand = male();
  const RigidTransform& frame = hand.hand_from_bone_at_bind[kThumbDistal];
  const std::vector<std::uint8_t> bones = strongest_bones(hand);
  for (std::size_t v = 0; v < bones.size(); ++v) {
    if (bones[v] != kThumbDistal) continue;
    Eigen::Vector3d place = frame.inverse() * hand.bind_mesh.vertices[v].cast<double>();
    const double radius = std::hypot(place.x(), place.z());
    if (radius > 0) place = {.007 * place.x() / radius, place.y(), .007 * place.z() / radius};
    hand.bind_mesh.vertices[v] = (frame * place).cast<float>();
  }
  expect_not_applicable(check_stated(hand), "nail, thumb", "the thumb's end is round or bare");
}

Hand with_index_tip(const Eigen::Vector3d& in_distal) {
  Hand hand = male();
  hand.skeleton.tip_in_distal[1] = in_distal;
  return hand;
}

TEST(HandCheckStated, ATipInsideOrOutsideTheFleshIsFound) {
  const double end = male().skeleton.tip_in_distal[1].y();
  for (const double length : {.012, end - .004, end + .004, .04}) {
    expect_fail(check_stated(with_index_tip({0, length, 0})), "tips on the skin", "index");
  }
  for (const double length : {end - .001, end + .001}) {
    expect_pass(check_stated(with_index_tip({0, length, 0})), "tips on the skin");
  }
}

TEST(HandCheckStated, ATipOnTheSideOfItsFingerIsFound) {
  const double end = male().skeleton.tip_in_distal[1].y();
  expect_fail(check_stated(with_index_tip({0, .6 * end, .0075})), "tips on the skin", "index");
}

TEST(HandCheckStated, TipsWithoutSkinAreNotJudged) {
  const int distal = finger_bone(3, kDistal);
  expect_not_applicable(check_stated(with_skin_of_given_to(distal, distal - 1)), "tips on the skin",
                        "little_distal moves no skin");
}

// Bound flat, with its flesh on the other side of its bones.
TEST(HandCheckStated, SignsAgainstThePalmsSideAreNamed) {
  Hand hand = bound_flat();
  for (Eigen::Vector3f& v : hand.bind_mesh.vertices) v.z() = -v.z();
  const Lines lines = check_stated(hand);
  expect_fail(lines, "palm side, signs against it", "of the palm's flesh");
  EXPECT_EQ(lines[0].value, 2);
}

TEST(HandCheckStated, APalmsSideThatNoSignTellsIsNotJudged) {
  Hand hand = bound_flat();
  for (SkinWeights& skin : hand.weights) skin = only(kForearm);
  hand.hand_from_bone_at_bind[kThumbMetacarpal].translation.z() = 0;
  expect_not_applicable(check_stated(hand), "palm side, signs against it", "no sign tells");
}

}  // namespace
}  // namespace graspdb::testing
