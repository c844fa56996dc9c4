// SPDX-License-Identifier: MIT
#include "model_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>

#include "graspdb/core/error.h"
#include "graspdb/core/opencv/opencv_image.h"
#include "graspdb/renderer/renderer.h"

namespace graspdb {
namespace {

constexpr int kOversampling = 2;         // for smooth outlines
constexpr double kDistance = 0.7;        // metres from the camera to the hand
constexpr double kForearmShown = -0.06;  // metres along y

using Tint = std::array<double, 3>;  // factors on grey: blue, green, red
constexpr Tint kSkin = {0.86, 0.98, 1.18};
constexpr Tint kMarked = {0.45, 0.75, 1.30};
constexpr Tint kObject = {1.10, 0.75, 0.50};

Eigen::Matrix3d camera_looking(const Side& side) {
  Eigen::Matrix3d rotation;
  const Eigen::Vector3d forward = side.looking.normalized();
  const Eigen::Vector3d right = forward.cross(side.up).normalized();
  rotation << right.transpose(), forward.cross(right).transpose(), forward.transpose();
  return rotation;
}

Bgr tinted(std::uint8_t gray, const Tint& tint) {
  Bgr color;
  for (std::size_t i = 0; i < 3; ++i) {
    color[i] = static_cast<std::uint8_t>(std::clamp(gray * tint[i], 0.0, 255.0));
  }
  return color;
}

const Tint& tint_of(std::uint8_t label, std::uint8_t part, const BoneSet& marked) {
  if (label == kObjectSurface) return kObject;
  return part > 0 && marked[part - 1] ? kMarked : kSkin;
}

}  // namespace

ColorImage colored(const View& view, const BoneSet& marked, std::uint8_t background) {
  GRASPDB_CHECK(marked.none() || !view.part.empty());
  ColorImage image(view.shading.width(), view.shading.height(),
                   {background, background, background});
  for (std::size_t i = 0; i < image.size(); ++i) {
    const std::uint8_t label = view.label.data()[i];
    if (label == kBackground) continue;
    image.data()[i] = tinted(view.shading.data()[i],
                             tint_of(label, view.part.empty() ? 0 : view.part.data()[i], marked));
  }
  return image;
}

ModelView::ModelView(const Hand& hand, const GraspPose& pose, const Solid* object)
    : posed_(pose_scene(hand, pose, object)) {
  for (const auto& v : posed_.hand_vertices) {
    if (v.y() > kForearmShown) framed_.push_back(v);
  }
}

cv::Mat_<cv::Vec3b> ModelView::seen(const Side& side, int pixels) const {
  return seen(side, pixels, framed_);
}

cv::Mat_<cv::Vec3b> ModelView::seen(const Side& side, int pixels, const Framed& framed,
                                    const BoneSet& marked) const {
  Eigen::Vector3f low = framed.front(), high = low;
  for (const auto& v : framed) low = low.cwiseMin(v), high = high.cwiseMax(v);
  const Eigen::Vector3d center = ((low + high) / 2).cast<double>();
  const Camera camera =
      crop_camera(camera_looking(side), center, kDistance, framed, pixels * kOversampling, 0.08);
  Light light;
  light.towards_light_in_camera = {-0.4, -0.6, -1};
  ColorImage large = colored(render(posed_.scene, camera, light, {.parts = true}), marked);
  cv::Mat_<cv::Vec3b> small;
  cv::resize(as_mat(large), small, {pixels, pixels}, 0, 0, cv::INTER_AREA);
  return small;
}

Page::Page(int width, int height) : image_(width, height, {kPaper, kPaper, kPaper}) {}

void Page::place(const cv::Mat_<cv::Vec3b>& picture, int x, int y) {
  picture.copyTo(as_mat(image_)(cv::Rect(x, y, picture.cols, picture.rows)));
}

void Page::write(const std::string& text, int x, int y) {
  write_sized(text, x, y, 0.45);
}

void Page::write_small(const std::string& text, int x, int y) {
  write_sized(text, x, y, 0.35);
}

void Page::write_sized(const std::string& text, int x, int y, double size) {
  cv::putText(as_mat(image_), text, {x, y}, cv::FONT_HERSHEY_SIMPLEX, size, {40, 40, 40}, 1,
              cv::LINE_AA);
}

}  // namespace graspdb
