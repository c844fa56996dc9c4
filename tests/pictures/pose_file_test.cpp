// SPDX-License-Identifier: MIT
#include "graspdb/pose_file.h"

#include <gmock/gmock.h>

#include "graspdb/error.h"
#include "graspdb/file.h"
#include "graspdb/transform.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using ::testing::HasSubstr;

const Eigen::Vector3d kFingers = Eigen::Vector3d::UnitY(), kBack = Eigen::Vector3d::UnitZ();

class PoseFileTest : public ::testing::Test {
 protected:
  PoseFile load(const std::string& text) {
    write_text(directory_ / "pose.toml", text);
    return load_pose(directory_ / "pose.toml");
  }
  std::string refusal(const std::string& text) {
    try {
      load(text);
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }
  testing::TemporaryDirectory directory_;
};

TEST_F(PoseFileTest, AnEmptyOneIsTheFlatHandWithItsPalmToTheCamera) {
  const PoseFile pose = load("");
  EXPECT_TRUE(pose.angles.isZero());
  EXPECT_LT((pose.camera_from_hand * kFingers - Eigen::Vector3d(0, -1, 0)).norm(), 1e-12);
  EXPECT_LT((pose.camera_from_hand * kBack - Eigen::Vector3d(0, 0, 1)).norm(), 1e-12);
}

TEST_F(PoseFileTest, TurnsAreAboutTheCamerasAxes) {
  const auto back = load("yaw_deg = 180").camera_from_hand;
  EXPECT_LT((back * kBack - Eigen::Vector3d(0, 0, -1)).norm(), 1e-12);
  EXPECT_LT((back * kFingers - Eigen::Vector3d(0, -1, 0)).norm(), 1e-12);
  const auto tipped = load("pitch_deg = 90").camera_from_hand;
  EXPECT_LT((tipped * kFingers - Eigen::Vector3d(0, 0, -1)).norm(), 1e-12);
  const auto rolled = load("roll_deg = 90").camera_from_hand;  // clockwise: from up to the right
  EXPECT_LT((rolled * kFingers - Eigen::Vector3d(1, 0, 0)).norm(), 1e-12);
  const auto quarter = load("yaw_deg = 90").camera_from_hand;  // the palm turns to the left
  EXPECT_LT((quarter * -kBack - Eigen::Vector3d(-1, 0, 0)).norm(), 1e-12);
}

TEST_F(PoseFileTest, ReadsAVectorAndAnglesByName) {
  const PoseFile pose =
      load("rotation_vector_deg = [0, 0, 180]\n[angles_deg]\nring_pip_flexion = 40\n");
  EXPECT_LT(angle_between(pose.camera_from_hand, rotation_from_turns(0, 0, 0)), 1e-7);
  EXPECT_NEAR(pose.angles[finger_angle(2, kPipFlexion)], radians(40), 1e-12);
  EXPECT_NEAR(pose.angles.norm(), radians(40), 1e-12);
}

TEST_F(PoseFileTest, AnEndOfARangeIsInsideIt) {
  for (int i = 0; i < kAngleCount; ++i) {
    const AngleInfo& info = angle_info(i);
    const std::string degrees_text = std::to_string(std::lround(degrees(info.upper)));
    EXPECT_NEAR(load("[angles_deg]\n" + std::string(info.name) + " = " + degrees_text).angles[i],
                info.upper, 1e-9);
  }
}

TEST_F(PoseFileTest, WhatIsWrongIsNamed) {
  EXPECT_THAT(refusal("[angles_deg]\nring_pip = 4"), HasSubstr("ring_pip"));
  EXPECT_THAT(refusal("[angles_deg]\nring_pip_flexion = 140"), HasSubstr("ring_pip_flexion"));
  EXPECT_THAT(refusal("yaw = 4"), HasSubstr("yaw"));
  EXPECT_THAT(refusal("yaw_deg = 4\nrotation_vector_deg = [0, 0, 0]"), HasSubstr("yaw_deg"));
  EXPECT_THAT(refusal("rotation_vector_deg = [0, 0]"), HasSubstr("rotation_vector_deg"));
}

}  // namespace
}  // namespace graspdb
