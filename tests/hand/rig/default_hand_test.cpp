// SPDX-License-Identifier: MIT
// What every hand that we ship must hold, tried on the files.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "graspdb/hand/check/hand_check.h"
#include "graspdb/hand/check/hand_file_check.h"
#include "graspdb/hand/hand.h"
#include "graspdb/hand/rig/rig.h"
#include "support/closed_surface.h"
#include "support/compare_hands.h"

namespace graspdb {
namespace {

struct Measures {
  std::string name;
  double length_mm, breadth_mm;
};

class DefaultHand : public ::testing::TestWithParam<Measures> {
 protected:
  const Hand hand_ = load_hand(GRASPDB_SOURCE_DIR "/assets/hands/" + GetParam().name + ".glb");
};

TEST_P(DefaultHand, SurfaceIsClosedAndOfOnePieceWithoutHandles) {
  const Mesh& mesh = hand_.bind_mesh;
  ASSERT_TRUE(testing::is_closed_surface(mesh));
  EXPECT_EQ(2 * mesh.vertices.size(), mesh.triangles.size() + 4);  // Euler
  EXPECT_GE(mesh.triangles.size(), 8000);
  EXPECT_LE(mesh.triangles.size(), 12000);
  EXPECT_GT(testing::volume(mesh), 2.5e-4);  // cubic metres, with the forearm
  EXPECT_LT(testing::volume(mesh), 1.2e-3);
}

TEST_P(DefaultHand, NormalsAreUnitAndPointOutwards) {
  const Mesh& mesh = hand_.bind_mesh;
  for (const Eigen::Vector3f& n : mesh.normals) ASSERT_NEAR(n.norm(), 1, 1e-5);
  for (const Triangle& t : mesh.triangles) {
    const Eigen::Vector3f& a = mesh.vertices[t[0]];
    const Eigen::Vector3f face = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
    ASSERT_GT(face.dot(mesh.normals[t[0]] + mesh.normals[t[1]] + mesh.normals[t[2]]), 0);
  }
}

TEST_P(DefaultHand, WeightsAreSharesOfBones) {
  for (const SkinWeights& skin : hand_.weights) {
    float sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      ASSERT_GE(skin.weight[i], 0);
      ASSERT_LT(skin.bone[i], kBoneCount);
      sum += skin.weight[i];
    }
    ASSERT_NEAR(sum, 1, 1e-6);
  }
}

TEST_P(DefaultHand, SkinAtTheBindPoseIsTheBindSkin) {
  // The angles that the maker binds at, so that this also ties skeleton and frames together.
  JointAngles bind = JointAngles::Zero();
  const double abduction[] = {9, 1, -8, -17};
  for (int f = 0; f < kFingerCount; ++f) {
    bind[finger_angle(f, kMcpFlexion)] = radians(30);
    bind[finger_angle(f, kMcpAbduction)] = radians(abduction[f]);
    bind[finger_angle(f, kPipFlexion)] = radians(45);
    bind[finger_angle(f, kDipFlexion)] = radians(25);
  }
  bind[kThumbCmcFlexion] = radians(20);
  bind[kThumbCmcAbduction] = radians(28);
  bind[kThumbCmcAxial] = radians(18);
  bind[kThumbMcpFlexion] = radians(10);
  bind[kThumbIpFlexion] = radians(14);
  EXPECT_EQ(range_excess(bind), 0);
  EXPECT_LT(testing::largest_difference(pose_skin(hand_, bind), hand_.bind_mesh), 1e-6);
  EXPECT_LT(
      testing::largest_difference(pose_skin(hand_, hand_.hand_from_bone_at_bind), hand_.bind_mesh),
      1e-6);
}

TEST_P(DefaultHand, IsAsLongAsAsked) {
  const double asked = GetParam().length_mm / 1000;
  EXPECT_NEAR(hand_length(hand_.skeleton), asked, 1e-6);
  double skin_tip = 0;
  for (const Eigen::Vector3f& v : pose_skin(hand_, JointAngles::Zero()).vertices) {
    skin_tip = std::max<double>(skin_tip, v.y());
  }
  EXPECT_NEAR(skin_tip, asked, .01 * asked);
}

TEST_P(DefaultHand, IsAsBroadAsAsked) {
  const auto& zero = hand_.skeleton.hand_from_bone_at_zero;
  const Eigen::Vector3d index = zero[finger_bone(0, kProximal)].translation;
  const Eigen::Vector3d little = zero[finger_bone(3, kProximal)].translation;
  const Eigen::Vector3d across = (little - index).normalized();
  const Eigen::Vector3d along = Eigen::Vector3d::UnitZ().cross(across).normalized();
  const std::vector<std::uint8_t> strongest = strongest_bones(hand_);
  double low = 0, high = 0;
  // Where the skin's edges cross the plane through the knuckles; the thumb does not count.
  for (const Triangle& t : hand_.bind_mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = t[i], to = t[(i + 1) % 3];
      const Eigen::Vector3d a = hand_.bind_mesh.vertices[from].cast<double>() - index;
      const Eigen::Vector3d b = hand_.bind_mesh.vertices[to].cast<double>() - index;
      if (strongest[from] < kFirstFingerBone || a.dot(along) * b.dot(along) >= 0) continue;
      const double part = a.dot(along) / (a - b).dot(along);
      const double place = (a + part * (b - a)).dot(across);
      low = std::min(low, place);
      high = std::max(high, place);
    }
  }
  EXPECT_NEAR(high - low, GetParam().breadth_mm / 1000, .00001 * GetParam().breadth_mm);
}

TEST_P(DefaultHand, HasAForearm) {
  double end = 0;
  for (const Eigen::Vector3f& v : hand_.bind_mesh.vertices) end = std::min<double>(end, v.y());
  EXPECT_LT(end, -.150);
}

TEST_P(DefaultHand, PassesEveryLineOfTheCheck) {
  std::vector<HandCheckLine> lines =
      check_hand_file(GRASPDB_SOURCE_DIR "/assets/hands/" + GetParam().name + ".glb");
  for (HandCheckLine& line :
       check_hand(hand_, AskedSize{GetParam().length_mm, GetParam().breadth_mm})) {
    lines.push_back(std::move(line));
  }
  for (const HandCheckLine& line : lines) {
    EXPECT_EQ(status_name(line.status), "pass")
        << line.name << ": " << line.value << " " << line.unit << ", gate " << line.gate << ", "
        << line.why;
  }
}

// What the angle should do to the part that it moves, seen from the palm.
struct Movement {
  int first_bone;  // the root of what moves
  int seen_bone;   // whose skin is looked at
  Eigen::Vector3d direction;
};

Movement movement_of(int angle) {
  const Eigen::Vector3d ulnar(1, 0, 0), palmar(0, 0, -1);
  if (angle == kWristFlexion) return {kForearm, kForearm, palmar};
  if (angle == kWristDeviation) return {kForearm, kForearm, -ulnar};
  if (angle == kThumbCmcFlexion) return {kThumbMetacarpal, kThumbDistal, ulnar};
  if (angle == kThumbCmcAbduction) return {kThumbMetacarpal, kThumbDistal, palmar};
  if (angle == kThumbCmcAxial) return {kThumbMetacarpal, kThumbDistal, Eigen::Vector3d::Zero()};
  if (angle == kThumbMcpFlexion) return {kThumbProximal, kThumbDistal, ulnar};
  if (angle == kThumbMcpAbduction) return {kThumbProximal, kThumbDistal, palmar};
  if (angle == kThumbIpFlexion) return {kThumbDistal, kThumbDistal, ulnar};
  const int finger = (angle - kFirstFingerAngle) / 5, part = (angle - kFirstFingerAngle) % 5;
  constexpr FingerBone kMoved[] = {kMetacarpal, kProximal, kProximal, kMiddle, kDistal};
  return {finger_bone(finger, kMoved[part]), finger_bone(finger, kDistal),
          part == kMcpAbduction ? Eigen::Vector3d(-ulnar) : palmar};
}

bool hangs_from(int bone, int ancestor) {
  for (; bone >= 0; bone = bone_parent(bone)) {
    if (bone == ancestor) return true;
  }
  return false;
}

class EveryAngle : public DefaultHand {
 protected:
  static JointAngles with(int angle) {
    JointAngles angles = JointAngles::Zero();
    angles[angle] = std::min(radians(15), angle_info(angle).upper);
    return angles;
  }
  const Mesh flat_ = pose_skin(hand_, JointAngles::Zero());
};

TEST_P(EveryAngle, MovesOnlyTheSkinOfItsOwnSubtree) {
  for (int angle = 0; angle < kAngleCount; ++angle) {
    const Mesh moved = pose_skin(hand_, with(angle));
    std::size_t count = 0;
    for (std::size_t v = 0; v < moved.vertices.size(); ++v) {
      double share = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        const bool below = hangs_from(hand_.weights[v].bone[i], movement_of(angle).first_bone);
        share += below ? hand_.weights[v].weight[i] : 0;
      }
      const double distance = (moved.vertices[v] - flat_.vertices[v]).norm();
      ASSERT_TRUE(share > 0 || distance < 1e-7) << angle_info(angle).name;
      count += distance > 1e-5;
    }
    EXPECT_GT(count, 50) << angle_info(angle).name;
    EXPECT_LT(count, moved.vertices.size() / 2) << angle_info(angle).name;
  }
}

TEST_P(EveryAngle, MovesTheSkinTheRightWay) {
  for (int angle = 0; angle < kAngleCount; ++angle) {
    const Movement expected = movement_of(angle);
    const Mesh moved = pose_skin(hand_, with(angle));
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    int count = 0;
    for (std::size_t v = 0; v < moved.vertices.size(); ++v) {
      if (hand_.weights[v].bone[0] != expected.seen_bone || hand_.weights[v].weight[0] < .9)
        continue;
      mean += (moved.vertices[v] - flat_.vertices[v]).cast<double>();
      ++count;
    }
    ASSERT_GT(count, 20) << angle_info(angle).name;
    mean /= count;
    if (expected.direction.isZero()) {
      EXPECT_LT(mean.norm(), .002) << angle_info(angle).name;  // it turns about its own axis
    } else {
      EXPECT_GT(mean.normalized().dot(expected.direction), .6) << angle_info(angle).name;
    }
  }
}

TEST_P(EveryAngle, AxialRotationTurnsTheThumbsPulpToTheFingers) {
  JointAngles before = JointAngles::Zero();
  before[kThumbCmcAbduction] = radians(45);
  JointAngles after = before;
  after[kThumbCmcAxial] = radians(40);
  const Mesh a = pose_skin(hand_, before), b = pose_skin(hand_, after);
  const RigidTransform bind = hand_.hand_from_bone_at_bind[kThumbDistal].inverse();
  double pulp_turned = 0;
  for (std::size_t v = 0; v < a.vertices.size(); ++v) {
    const SkinWeights& skin = hand_.weights[v];
    if (skin.bone[0] != kThumbDistal || skin.weight[0] < .99) continue;
    const Eigen::Vector3d normal = bind.rotation * hand_.bind_mesh.normals[v].cast<double>();
    if (normal.z() < -.7) pulp_turned += b.normals[v].z() - a.normals[v].z();
  }
  EXPECT_GT(pulp_turned, 0);  // the pulp looks dorsally, to where the fingers' pulps are
}

const auto kDefaults = ::testing::Values(Measures{"male", 193, 88}, Measures{"female", 180, 78},
                                         Measures{"slender", 190, 76}, Measures{"child", 140, 66});
const auto kName = [](const auto& info) { return info.param.name; };
INSTANTIATE_TEST_SUITE_P(Hands, DefaultHand, kDefaults, kName);
INSTANTIATE_TEST_SUITE_P(Hands, EveryAngle, kDefaults, kName);

}  // namespace
}  // namespace graspdb
