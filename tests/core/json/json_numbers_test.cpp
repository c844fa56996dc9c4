// SPDX-License-Identifier: MIT
#include "graspdb/core/json/json_numbers.h"

#include <gtest/gtest.h>

#include "graspdb/core/json/strict_json.h"

namespace graspdb {
namespace {

using nlohmann::json;

TEST(JsonNumbers, MatricesAndFramesGoRowByRowAndPointsColumnByColumn) {
  const Eigen::Matrix<double, 2, 3> matrix{{1, 2, 3}, {4, 5, 6}};
  EXPECT_EQ(json(numbers(matrix)).dump(), "[1.0,2.0,3.0,4.0,5.0,6.0]");
  EXPECT_EQ(json(numbers(matrix.transpose())).dump(), "[1.0,4.0,2.0,5.0,3.0,6.0]");
  EXPECT_EQ(json(points(matrix)).dump(), "[[1.0,4.0],[2.0,5.0],[3.0,6.0]]");
  const RigidTransform frame{Eigen::Matrix3d::Identity(), {7, 8, 9}};
  EXPECT_EQ(json(numbers(frame)).dump(), "[1.0,0.0,0.0,7.0,0.0,1.0,0.0,8.0,0.0,0.0,1.0,9.0]");
}

TEST(JsonNumbers, RoundingIsToTheNearestStepAndNeverGivesMinusZero) {
  EXPECT_EQ(json(numbers(Eigen::Vector3d(1.26, -0.04, -0.06), 10)).dump(), "[1.3,0.0,-0.1]");
}

TEST(JsonNumbers, ACameraIsReadAsItWasWritten) {
  const Intrinsics camera{640, 480, 1.0 / 3, 501, -7.5, 239.5};
  EXPECT_EQ(json(camera_matrix(camera)).dump(), "[0.333333,0.0,-7.5,0.0,501.0,239.5,0.0,0.0,1.0]");
  const json written = json::parse(camera_json(camera).dump());
  const Intrinsics back = read_camera(JsonFields(written, "f.json", "camera"));
  EXPECT_EQ(back.width, 640);
  EXPECT_EQ(back.height, 480);
  EXPECT_EQ(back.fx, camera.fx);
  EXPECT_EQ(back.fy, 501);
  EXPECT_EQ(back.cx, -7.5);
  EXPECT_EQ(back.cy, 239.5);
}

}  // namespace
}  // namespace graspdb
