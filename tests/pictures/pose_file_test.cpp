// SPDX-License-Identifier: MIT
#include "graspdb/pictures/pose_file.h"

#include <gmock/gmock.h>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/transform.h"
#include "graspdb/hand/turns.h"
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

TEST_F(PoseFileTest, AnEmptyOneIsTheFlatHandWithItsBackToTheCamera) {
  const PoseFile pose = load("");
  EXPECT_TRUE(pose.angles.isZero());
  EXPECT_LT((pose.rotation * kFingers - Eigen::Vector3d(0, -1, 0)).norm(), 1e-12);
  EXPECT_LT((pose.rotation * kBack - Eigen::Vector3d(0, 0, -1)).norm(), 1e-12);
}

TEST_F(PoseFileTest, TurnsAreAboutTheCamerasAxes) {
  const auto palm = load("view_deg = [180, 0, 0]").rotation;
  EXPECT_LT((palm * kBack - Eigen::Vector3d(0, 0, 1)).norm(), 1e-12);
  EXPECT_LT((palm * kFingers - Eigen::Vector3d(0, -1, 0)).norm(), 1e-12);
  const auto tipped = load("view_deg = [0, 90, 0]").rotation;
  EXPECT_LT((tipped * kFingers - Eigen::Vector3d(0, 0, -1)).norm(), 1e-12);
  const auto rolled = load("view_deg = [0, 0, 90]").rotation;  // clockwise: from up to the right
  EXPECT_LT((rolled * kFingers - Eigen::Vector3d(1, 0, 0)).norm(), 1e-12);
  const auto quarter = load("view_deg = [90, 0, 0]").rotation;  // the back turns to the left
  EXPECT_LT((quarter * kBack - Eigen::Vector3d(-1, 0, 0)).norm(), 1e-12);
}

TEST_F(PoseFileTest, ReadsAVectorAndAnglesByName) {
  const PoseFile pose =
      load("rotation_vector_deg = [0, 0, 180]\n[angles_deg]\nring_pip_flexion = 40\n");
  EXPECT_LT(angle_between(pose.rotation, rotation_from_turns({kPi, 0, 0})), 1e-7);
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
  EXPECT_THAT(refusal("view = 4"), HasSubstr("view"));
  EXPECT_THAT(refusal("view_deg = [4, 0, 0]\nrotation_vector_deg = [0, 0, 0]"),
              HasSubstr("view_deg"));
  EXPECT_THAT(refusal("rotation_vector_deg = [0, 0]"), HasSubstr("rotation_vector_deg"));
}

TEST_F(PoseFileTest, KeysWhoseZeroWasAnotherAreRefusedWithWhatStandsForThem) {
  for (const char* key : {"yaw_deg", "pitch_deg", "roll_deg"}) {
    const std::string told = refusal(std::string(key) + " = 10");
    EXPECT_THAT(told, HasSubstr(key));
    EXPECT_THAT(told, HasSubstr("view_deg = [yaw + 180, pitch, roll]"));
  }
}

}  // namespace
}  // namespace graspdb
