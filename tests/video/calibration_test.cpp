// SPDX-License-Identifier: MIT
#include "graspdb/video/calibration.h"

#include <gmock/gmock.h>

#include <opencv2/core.hpp>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using ::testing::HasSubstr;

class CalibrationFile : public ::testing::Test {
 protected:
  CameraCalibration read(const std::string& text, const std::string& name = "camera.txt") const {
    write_text(directory_ / name, text);
    return read_calibration(directory_ / name);
  }
  void expect_refused(const std::string& text, const std::string& told) const {
    try {
      read(text);
      ADD_FAILURE() << text << " was read";
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("camera.txt"));
      EXPECT_THAT(error.what(), HasSubstr(told));
    }
  }
  // As OpenCV's own calibration program writes it.
  CameraCalibration read_opencv(const std::string& name, double bend) const {
    const cv::Mat matrix = (cv::Mat_<double>(3, 3) << 500, 0, 310, 0, 510, 250, 0, 0, 1);
    const cv::Mat bends = (cv::Mat_<double>(1, 5) << bend, 0, 0, 0, 0);
    cv::FileStorage storage((directory_ / name).string(), cv::FileStorage::WRITE);
    storage << "image_width" << 640 << "image_height" << 480 << "camera_matrix" << matrix
            << "distortion_coefficients" << bends;
    storage.release();
    return read_calibration(directory_ / name);
  }

  testing::TemporaryDirectory directory_;
};

const std::string kMatrix =
    "%YAML:1.0\n---\ncamera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
    "   data: [ 500., 0., 310., 0., 510., 250., 0., 0., 1. ]\n";

void expect_camera(const Intrinsics& camera, double fx, double fy, double cx, double cy) {
  EXPECT_DOUBLE_EQ(camera.fx, fx);
  EXPECT_DOUBLE_EQ(camera.fy, fy);
  EXPECT_DOUBLE_EQ(camera.cx, cx);
  EXPECT_DOUBLE_EQ(camera.cy, cy);
}

TEST_F(CalibrationFile, OfOpenCV) {
  for (const char* name : {"a.yml", "a.json"}) {
    const CameraCalibration read = read_opencv(name, 0);
    expect_camera(read.camera, 500, 510, 310, 250);
    EXPECT_EQ(read.camera.width, 640);
    EXPECT_EQ(read.camera.height, 480);
    EXPECT_FALSE(read.distorted);
    EXPECT_TRUE(read_opencv(name, 0.1).distorted);
  }
}

TEST_F(CalibrationFile, OfColmapWhosePixelsBeginAtTheirCorners) {
  const CameraCalibration pinhole = read(
      "# Camera list\n#   CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]\n\n"
      "1 PINHOLE 640 480 500 510 320 240\n");
  expect_camera(pinhole.camera, 500, 510, 319.5, 239.5);
  EXPECT_EQ(pinhole.camera.width, 640);
  EXPECT_FALSE(pinhole.distorted);
  const CameraCalibration radial = read("1 SIMPLE_RADIAL 640 480 500 320 240 .02");
  expect_camera(radial.camera, 500, 500, 319.5, 239.5);
  EXPECT_TRUE(radial.distorted);
}

TEST_F(CalibrationFile, OfNineNumbers) {
  for (const char* text : {"500 0 310\n0 510 250\n0 0 1\n", "500, 0, 310, 0, 510, 250, 0, 0, 1"}) {
    const CameraCalibration matrix = read(text);
    expect_camera(matrix.camera, 500, 510, 310, 250);
    EXPECT_EQ(matrix.camera.width, 0);
  }
}

TEST_F(CalibrationFile, OfAnythingElseIsRefused) {
  expect_refused("", "calibration");
  expect_refused("hello", "COLMAP");
  expect_refused("500 0 310 0 510 250 0 0", "COLMAP");
  expect_refused("500 0 310 0 510 250 0 0 2", "camera matrix");
  expect_refused("-500 0 310 0 510 250 0 0 1", "focal lengths");
  expect_refused("nan 0 310 0 510 250 0 0 1", "");
  expect_refused("1 FISHEYE 640 480 1 2 3 4", "FISHEYE");
  expect_refused("1 PINHOLE 640 480 500 510 320", "4 parameters");
  expect_refused("1 PINHOLE 640 480 500 510 320 240 .1 .2", "4 parameters");
  expect_refused("500 0 310 0 510 250 0 0 1 -", "COLMAP");
  expect_refused("500 3 310 0 510 250 0 0 1", "skew");
  expect_refused(kMatrix + "image_width: 640.5\nimage_height: 480\n", "image_width");
  expect_refused(kMatrix + "distortion_coefficients: bent\n", "distortion_coefficients");
  EXPECT_TRUE(read(kMatrix + "distortion_coefficients: [ 0.1, 0.2 ]\n").distorted);
  expect_refused("1 PINHOLE 0 480 500 510 320 240", "size");
  expect_refused("1 PINHOLE 640 480 500 510 320 240\n2 PINHOLE 640 480 500 510 320 240", "2 lines");
  expect_refused("%YAML:1.0\n---\nimage_width: 640\n", "camera_matrix");
  expect_refused("%YAML:1.0\n---\ncamera_matrix: 3\n", "camera_matrix");
  expect_refused("%YAML:1.0\n---\n}{", "OpenCV");
  expect_refused("%YAML:1.0\n---\ncamera_matrix: { rows: 3 }\n", "camera_matrix");
  expect_refused("<?xml version=\"1.0\"?>\n<opencv_storage></opencv_storage>\n", "XML");
  EXPECT_THROW(read_calibration(directory_ / "none.txt"), Error);
}

TEST(Calibration, OfOneSizeServesAllOfItsShape) {
  const Intrinsics camera{
      .width = 640, .height = 480, .fx = 500, .fy = 510, .cx = 319.5, .cy = 250};
  const Intrinsics half = scaled_to(camera, 320, 240, "camera.txt");
  EXPECT_EQ(half.width, 320);
  expect_camera(half, 250, 255, 159.5, 124.75);
  EXPECT_THROW(scaled_to(camera, 480, 640, "camera.txt"), Error);
  // A matrix that states no size is one for pictures of any.
  expect_camera(scaled_to({.fx = 500, .fy = 510, .cx = 310, .cy = 250}, 320, 240, ""), 500, 510,
                310, 250);
}

}  // namespace
}  // namespace graspdb
