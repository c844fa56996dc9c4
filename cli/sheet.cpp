// SPDX-License-Identifier: MIT
#include "sheet.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>
#include <string>

#include "graspdb/posed_scene.h"
#include "graspdb/renderer.h"

namespace graspdb {
namespace {

constexpr int kTile = 300;        // pixels
constexpr int kOversampling = 2;  // for smooth outlines
constexpr int kStepTile = 180;
constexpr int kPageTile = 230;
constexpr double kDistance = 0.7;        // metres from the camera to the hand
constexpr double kForearmShown = -0.06;  // metres along y

using Tint = std::array<double, 3>;  // factors on grey: blue, green, red
constexpr Tint kSkin = {0.86, 0.98, 1.18};
constexpr Tint kObject = {1.10, 0.75, 0.50};
constexpr std::uint8_t kPaper = 250;

struct Side {
  const char* name;
  Eigen::Vector3d looking;  // hand frame
  Eigen::Vector3d up;
};

const std::array<Side, 6>& sides() {
  static const std::array<Side, 6> all = {{
      {"palm", {0, 0.1, 1}, {0, 1, 0}},
      {"thumb side", {1, 0, 0.15}, {0, 1, 0}},
      {"back", {0, 0, -1}, {0, 1, 0}},
      {"little finger side", {-1, 0, 0.2}, {0, 1, 0}},
      {"finger tips", {0, -1, 0.25}, {0, 0, 1}},
      {"between thumb and palm", {0.75, -0.25, 0.75}, {0, 1, 0}},
  }};
  return all;
}
constexpr std::size_t kThumbSide = 1;
// The two that tell most: into the hand from above the finger tips, and from below the thumb.
const std::array<Side, 2>& telling_sides() {
  static const std::array<Side, 2> two = {
      {{"from above", {0.7, -0.5, 0.7}, {0, 1, 0}}, {"from below", {0.45, 0.35, 0.9}, {0, 1, 0}}}};
  return two;
}

Eigen::Matrix3d camera_looking(const Side& side) {
  Eigen::Matrix3d camera_from_hand;
  const Eigen::Vector3d forward = side.looking.normalized();
  const Eigen::Vector3d right = forward.cross(side.up).normalized();
  camera_from_hand << right.transpose(), forward.cross(right).transpose(), forward.transpose();
  return camera_from_hand;
}

Bgr tinted(std::uint8_t grey, const Tint& tint) {
  Bgr colour;
  for (std::size_t i = 0; i < 3; ++i) {
    colour[i] = static_cast<std::uint8_t>(std::clamp(grey * tint[i], 0.0, 255.0));
  }
  return colour;
}

cv::Mat_<cv::Vec3b> as_mat(ColorImage& image) {
  return {image.height(), image.width(), reinterpret_cast<cv::Vec3b*>(image.data())};
}

ColorImage coloured(const View& view) {
  ColorImage image(view.shading.width(), view.shading.height(), {kPaper, kPaper, kPaper});
  for (std::size_t i = 0; i < image.size(); ++i) {
    const std::uint8_t label = view.label.data()[i];
    if (label == kBackground) continue;
    image.data()[i] = tinted(view.shading.data()[i], label == kHandSurface ? kSkin : kObject);
  }
  return image;
}

// A posed hand with its object, ready to be seen from several sides.
class Model {
 public:
  Model(const Hand& hand, const Grasp& grasp, const GraspPose& pose)
      : posed_(pose_scene(hand, pose, grasp.object.get())) {
    for (const auto& v : posed_.hand_vertices) {
      if (v.y() > kForearmShown) framed_.push_back(v);
    }
  }

  // Squares of `pixels`, the hand fills them.
  cv::Mat_<cv::Vec3b> seen(const Side& side, int pixels) const {
    Eigen::Vector3f low = framed_.front(), high = low;
    for (const auto& v : framed_) low = low.cwiseMin(v), high = high.cwiseMax(v);
    const Eigen::Vector3d centre = ((low + high) / 2).cast<double>();
    const Camera camera =
        crop_camera(camera_looking(side), centre, kDistance, framed_, pixels * kOversampling, 0.08);
    Light light;
    light.towards_light_in_camera = {-0.4, -0.6, -1};
    ColorImage large = coloured(render(posed_.scene, camera, light));
    cv::Mat_<cv::Vec3b> small;
    cv::resize(as_mat(large), small, {pixels, pixels}, 0, 0, cv::INTER_AREA);
    return small;
  }

 private:
  PosedScene posed_;
  std::vector<Eigen::Vector3f> framed_;
};

void write_label(cv::Mat_<cv::Vec3b>& picture, const std::string& text, cv::Point at) {
  cv::putText(picture, text, at, cv::FONT_HERSHEY_SIMPLEX, 0.45, {40, 40, 40}, 1, cv::LINE_AA);
}

void place(cv::Mat_<cv::Vec3b>& page, const cv::Mat_<cv::Vec3b>& tile, int x, int y) {
  tile.copyTo(page(cv::Rect(x, y, tile.cols, tile.rows)));
}

}  // namespace

ColorImage draw_grasp_sheet(const Hand& hand, const Grasp& grasp, const JointAngles& rest,
                            const GraspPose& closed) {
  constexpr int kColumns = 3, kTitle = 30;
  constexpr int kStepsTop = kTitle + 2 * kTile;
  ColorImage page(kColumns * kTile, kStepsTop + kStepTile, {kPaper, kPaper, kPaper});
  cv::Mat_<cv::Vec3b> picture = as_mat(page);
  const Model model(hand, grasp, closed);
  for (int i = 0; i < static_cast<int>(sides().size()); ++i) {
    const Side& side = sides()[static_cast<std::size_t>(i)];
    const int x = i % kColumns * kTile, y = kTitle + i / kColumns * kTile;
    place(picture, model.seen(side, kTile), x, y);
    write_label(picture, side.name, {x + 8, y + kTile - 8});
  }
  for (int step = 1; step <= kStepCount; ++step) {
    const Model stepped(hand, grasp, pose_at_step(grasp, rest, closed, step));
    place(picture, stepped.seen(sides()[kThumbSide], kStepTile), (step - 1) * kStepTile, kStepsTop);
    write_label(picture, fmt::format("step {}", step),
                {(step - 1) * kStepTile + 8, kStepsTop + 16});
  }
  write_label(picture, fmt::format("{} {}: {}", grasp.id, grasp.name, grasp.object_name), {8, 20});
  return page;
}

ColorImage draw_grasp_page(const Hand& hand, const std::vector<Grasp>& grasps,
                           const std::map<int, GraspPose>& closed, bool plain) {
  constexpr int kColumns = 3, kTileWidth = 2 * kPageTile;
  const int title = plain ? 0 : 24;
  const int rows = (static_cast<int>(grasps.size()) + kColumns - 1) / kColumns;
  ColorImage page(kColumns * kTileWidth, rows * (kPageTile + title), {kPaper, kPaper, kPaper});
  cv::Mat_<cv::Vec3b> picture = as_mat(page);
  for (int i = 0; i < static_cast<int>(grasps.size()); ++i) {
    const Grasp& grasp = grasps[static_cast<std::size_t>(i)];
    const int x = i % kColumns * kTileWidth, y = i / kColumns * (kPageTile + title);
    const Model model(hand, grasp, closed.at(grasp.id));
    place(picture, model.seen(telling_sides()[0], kPageTile), x, y + title);
    place(picture, model.seen(telling_sides()[1], kPageTile), x + kPageTile, y + title);
    if (!plain) write_label(picture, fmt::format("{} {}", grasp.id, grasp.name), {x + 8, y + 17});
  }
  return page;
}

}  // namespace graspdb
