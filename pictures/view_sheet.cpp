// SPDX-License-Identifier: MIT
#include "graspdb/pictures/view_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "graspdb/core/opencv/opencv_image.h"
#include "model_view.h"

namespace graspdb {
namespace {

constexpr int kLayerTile = 320;  // pixels
constexpr Bgr kBlack = {24, 24, 24};
constexpr std::array<Bgr, 5> kDigitPaints = {
    {{60, 60, 220}, {40, 150, 240}, {70, 180, 60}, {210, 140, 40}, {190, 70, 170}}};
constexpr Bgr kPalmColor = {170, 200, 225};
constexpr Bgr kForearmColor = {140, 150, 160};
constexpr Bgr kObjectColor = {190, 130, 60};

using Mat = cv::Mat_<cv::Vec3b>;

template <typename Pixel, typename Color>
ColorImage painted(const Image<Pixel>& layer, Color color) {
  ColorImage picture(layer.width(), layer.height());
  std::transform(layer.begin(), layer.end(), picture.begin(), color);
  return picture;
}

int digit_of_bone(int bone) {
  return bone < kFirstFingerBone ? 0 : 1 + (bone - kFirstFingerBone) / 4;
}

// Digits by colour, the bones of each from dark to light.
Bgr part_color(std::uint8_t part) {
  const int bone = part - 1;
  if (bone < 0) return kBlack;
  if (bone == kPalm) return kPalmColor;
  if (bone == kForearm) return kForearmColor;
  const int digit = digit_of_bone(bone);
  const int place = digit == 0 ? bone - kThumbMetacarpal : (bone - kFirstFingerBone) % 4;
  Bgr color = kDigitPaints[static_cast<std::size_t>(digit)];
  for (std::uint8_t& channel : color) {
    channel = static_cast<std::uint8_t>(channel + (255 - channel) * place / 6);
  }
  return color;
}

Bgr label_color(std::uint8_t label) {
  if (label == kBackground) return kBlack;
  return label == kHandSurface ? kPalmColor : kObjectColor;
}

Bgr normal_color(const Eigen::Vector3f& n) {
  if (n.isZero()) return kBlack;
  // As normals are mostly shown: red to the right, green up, blue towards the eye.
  const auto channel = [](float v) { return static_cast<std::uint8_t>(127.5F + 127.5F * v); };
  return {channel(-n.z()), channel(-n.y()), channel(n.x())};
}

// The near end white, the far end dark; the range is this picture's own.
ColorImage depth_picture(const Image<float>& depth) {
  float near = std::numeric_limits<float>::infinity(), far = 0;
  for (const float z : depth) {
    near = std::min(near, z);
    if (std::isfinite(z)) far = std::max(far, z);
  }
  return painted(depth, [&](float z) -> Bgr {
    if (!std::isfinite(z)) return kBlack;
    const float gray = 255 - 190 * (z - near) / std::max(far - near, 1e-6F);
    const auto channel = static_cast<std::uint8_t>(gray);
    return {channel, channel, channel};
  });
}

ColorImage mask_picture(const Mask& mask, const Bgr& color) {
  return painted(mask, [&](std::uint8_t inside) { return inside != 0 ? color : kBlack; });
}

Mat layer_picture(ColorImage picture) {
  Mat scaled;
  const int method = picture.width() < kLayerTile ? cv::INTER_NEAREST : cv::INTER_AREA;
  cv::resize(as_mat(picture), scaled, {kLayerTile, kLayerTile}, 0, 0, method);
  return scaled;
}

// Of the centre of a pixel, at 1/16 of a tile's pixel.
constexpr int kShift = 4;
cv::Point on_tile(const LabelledView& view, int keypoint) {
  const double scale = static_cast<double>(kLayerTile) / view.camera.intrinsics.width;
  const Eigen::Vector2d at = (view.joints_px.col(keypoint).array() + 0.5) * scale - 0.5;
  return {static_cast<int>(std::lround(at.x() * (1 << kShift))),
          static_cast<int>(std::lround(at.y() * (1 << kShift)))};
}

// Visible keypoints are filled, hidden ones are rings.
void draw_keypoints(Mat& picture, const LabelledView& view) {
  for (int i = 1; i < kKeypointCount; ++i) {
    const Bgr& color = kDigitPaints[static_cast<std::size_t>((i - 1) / 4)];
    const int parent = i % 4 == 1 ? 0 : i - 1;
    cv::line(picture, on_tile(view, parent), on_tile(view, i),
             cv::Scalar(color[0], color[1], color[2]), 1, cv::LINE_AA, kShift);
  }
  for (int i = 0; i < kKeypointCount; ++i) {
    const bool visible = view.joint_states[static_cast<std::size_t>(i)] == kVisibleInPicture;
    const Bgr& color = i == 0 ? kForearmColor : kDigitPaints[static_cast<std::size_t>((i - 1) / 4)];
    cv::circle(picture, on_tile(view, i), 5 << kShift, cv::Scalar(color[0], color[1], color[2]),
               visible ? cv::FILLED : 1, cv::LINE_AA, kShift);
  }
}

std::string occlusion_text(const char* of, const PixelCounts& counts) {
  const auto hidden = counts.occlusion();
  return hidden ? fmt::format("{} amodal, {:.0f} % hidden", of, 100 * *hidden)
                : fmt::format("{} amodal: none", of);
}

}  // namespace

ColorImage draw_view_sheet(const LabelledView& view, const std::string& title) {
  constexpr int kColumns = 4, kTitle = 30, kCaption = 22;
  Mat keypoints = layer_picture(colored(view.picture));
  draw_keypoints(keypoints, view);
  const std::array<std::pair<std::string, Mat>, 8> tiles = {{
      {"keypoints (rings: hidden)", keypoints},
      {"shading", layer_picture(painted(view.picture.shading,
                                        [](std::uint8_t g) {
                                          return Bgr{g, g, g};
                                        }))},
      {"label", layer_picture(painted(view.picture.label, label_color))},
      {"part", layer_picture(painted(view.picture.part, part_color))},
      {"depth", layer_picture(depth_picture(view.picture.depth))},
      {"normal", layer_picture(painted(view.picture.normal, normal_color))},
      {occlusion_text("hand", view.hand),
       layer_picture(mask_picture(view.picture.hand_amodal, kPalmColor))},
      {occlusion_text("object", view.object),
       layer_picture(mask_picture(view.picture.object_amodal, kObjectColor))},
  }};
  const int rows = static_cast<int>(tiles.size()) / kColumns;
  Page page(kColumns * kLayerTile, kTitle + rows * (kLayerTile + kCaption));
  page.write(title, 8, 20);
  for (int i = 0; i < static_cast<int>(tiles.size()); ++i) {
    const auto& [caption, picture] = tiles[static_cast<std::size_t>(i)];
    const int x = i % kColumns * kLayerTile, y = kTitle + i / kColumns * (kLayerTile + kCaption);
    page.place(picture, x, y);
    page.write(caption, x + 8, y + kLayerTile + 15);
  }
  return page.image();
}

}  // namespace graspdb
