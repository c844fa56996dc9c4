// SPDX-License-Identifier: MIT
#include "sample_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "crop_frame.h"
#include "draw_rotation.h"
#include "graspdb/core/opencv/opencv_image.h"
#include "graspdb/core/transform.h"
#include "mask_errors.h"

namespace graspdb {
namespace {

// Of a crop's pixels, less of a hand tells nothing.
constexpr int kFewestPixels = 150;

Light draw_light(const SampleConfig& config, RandomStream& random) {
  Light light;
  const double ambient = random.uniform(0.15, 0.6), diffuse = random.uniform(0.3, 0.8);
  const Eigen::Vector3d towards(0.8 * random.normal(), 0.8 * random.normal() - 0.3, -1);
  light.ambient += config.light * (ambient - light.ambient);
  light.diffuse += config.light * (diffuse - light.diffuse);
  light.softness = std::clamp(config.light * random.uniform(-0.5, 1), 0.0, 1.0);
  light.towards_light_in_camera += config.light * (towards - light.towards_light_in_camera);
  return light;
}

// Of something between the light and the hand: its edges are as soft as the light is wide. It may
// miss the hand.
cv::Mat_<float> draw_shadow(const cv::Size& size, double softness, RandomStream& random) {
  const Outline outline = random.uniform() < 0.5 ? Outline::kEllipse : Outline::kRectangle;
  Mask shape = draw_outline(size.width, size.height, outline, 0.1, 0.6, random);
  const cv::Mat image = as_mat(shape);
  constexpr double kWidestEdge = 20;  // pixels
  const int edge = 1 + static_cast<int>(std::lround(kWidestEdge * softness));
  cv::blur(image, image, {edge, edge});
  cv::Mat_<float> shadow;
  image.convertTo(shadow, CV_32F, -random.uniform(0.15, 0.7) / 255);
  return shadow;
}

// Values that vary slowly over the picture, about 0 with this standard deviation or so.
cv::Mat_<float> draw_field(const cv::Size& size, int cells, double amplitude,
                           RandomStream& random) {
  cv::Mat_<float> coarse(cells, cells), field;
  for (float& value : coarse) value = static_cast<float>(amplitude * random.normal());
  cv::resize(coarse, field, size, 0, 0, cv::INTER_LINEAR);
  return field;
}

// What pixels of one label look like: shading times a brightness that varies about a mean, or that
// brightness alone.
struct Paint {
  float mean = 1;
  cv::Mat_<float> patches;
  bool is_shaded = true;
};

Paint draw_skin(const cv::Size& size, const SampleConfig& config, RandomStream& random) {
  cv::Mat_<float> patches = draw_field(size, 5, 0.12 * config.skin * random.uniform(), random);
  patches += draw_field(size, 24, 0.05 * config.skin * random.uniform(), random);
  return {1, patches, true};
}

Paint draw_object(const cv::Size& size, RandomStream& random) {
  const auto mean = static_cast<float>(random.uniform(0.1, 1.6));
  const int cells = 2 + static_cast<int>(random.below(14));
  return {mean, draw_field(size, cells, 0.3 * random.uniform(), random), true};
}

Paint draw_wall(const cv::Size& size, RandomStream& random) {
  const auto mean = static_cast<float>(random.uniform(10, 230));
  const int cells = 2 + static_cast<int>(random.below(20));
  return {mean, draw_field(size, cells, 60 * random.uniform(), random), false};
}

// By SurfaceLabel.
using Paints = std::array<Paint, 3>;

GrayImage painted(const View& view, const Paints& paints) {
  GrayImage gray(view.shading.width(), view.shading.height());
  for (int y = 0; y < gray.height(); ++y) {
    for (int x = 0; x < gray.width(); ++x) {
      const Paint& paint = paints[view.label.at(x, y)];
      const float level = paint.is_shaded ? view.shading.at(x, y) : 1.0F;
      const float brightness = paint.mean + paint.patches(y, x);
      gray.at(x, y) = static_cast<std::uint8_t>(std::clamp(level * brightness, 0.0F, 255.0F));
    }
  }
  return gray;
}

// The curve from light to grey level, another one in each camera and on each skin.
void apply_gamma(GrayImage& gray, double gamma) {
  std::array<std::uint8_t, 256> curve{};
  for (std::size_t i = 0; i < curve.size(); ++i) {
    curve[i] =
        static_cast<std::uint8_t>(std::lround(255 * std::pow(static_cast<double>(i) / 255, gamma)));
  }
  for (std::uint8_t& level : gray) level = curve[level];
}

// Sums of four bytes are normal enough, and eight noises cost two draws.
void add_noise(GrayImage& gray, double deviation, RandomStream& random) {
  constexpr double kDeviationOfSum = 147.8;  // of four even bytes
  const auto scale = static_cast<float>(deviation / kDeviationOfSum);
  for (std::size_t i = 0; i < gray.size(); i += 2) {
    const std::uint64_t bits = random.bits();
    const auto byte = [bits](int n) { return static_cast<int>(bits >> (8 * n) & 255); };
    const std::array<int, 2> sums = {byte(0) + byte(1) + byte(2) + byte(3),
                                     byte(4) + byte(5) + byte(6) + byte(7)};
    for (std::size_t k = 0; k < 2 && i + k < gray.size(); ++k) {
      std::uint8_t& level = gray.data()[i + k];
      const float noisy = static_cast<float>(level) + scale * static_cast<float>(sums[k] - 510);
      level = static_cast<std::uint8_t>(std::clamp(noisy, 0.0F, 255.0F));
    }
  }
}

void photograph(GrayImage& gray, const SampleConfig& config, RandomStream& random) {
  const double blur = config.sensor * random.uniform(0, 1.2), noise = random.uniform(0, 10);
  const double gamma = std::exp(random.uniform(std::log(0.4), std::log(1.6)));
  apply_gamma(gray, std::pow(gamma, config.skin));
  const cv::Mat image = as_mat(gray);
  if (blur > 0.3) cv::GaussianBlur(image, image, {}, blur);
  if (config.sensor > 0) add_noise(gray, config.sensor * noise, random);
}

// Another object before hand and all: a small round one, or a book or the picture's own border.
Mask draw_occluder(const View& view, RandomStream& random) {
  const int width = view.label.width(), height = view.label.height();
  if (random.uniform() < 0.5) {
    return draw_outline(width, height, Outline::kEllipse, 0.04, 0.25, random);
  }
  return draw_outline(width, height, Outline::kRectangle, 0.05, 0.6, random);
}

void hide_behind_object(View& view, RandomStream& random) {
  const Mask object = draw_occluder(view, random);
  const auto level = static_cast<std::uint8_t>(random.uniform(60, 220));
  for (std::size_t i = 0; i < object.size(); ++i) {
    if (object.data()[i] == 0) continue;
    view.label.data()[i] = kObjectSurface;
    view.shading.data()[i] = level;
  }
}

std::optional<ArmInPicture> arm_in_picture(const Camera& camera,
                                           const Eigen::Vector3d& towards_elbow) {
  constexpr double kLengthMm = 40, kShortestShare = 0.25;  // of what is seen from the side
  const Eigen::Vector3d wrist = camera.camera_from_hand.translation;
  const Eigen::Vector3d further = camera.camera_from_hand * (towards_elbow * kLengthMm / 1000);
  if (std::min(wrist.z(), further.z()) < kNearestDepth) return std::nullopt;
  const Eigen::Vector2d from = camera.intrinsics.project(wrist);
  const Eigen::Vector2d along = camera.intrinsics.project(further) - from;
  const double across = camera.intrinsics.fx / wrist.z() / kMillimetersPerMeter;
  if (along.norm() < kShortestShare * kLengthMm * across) return std::nullopt;
  return ArmInPicture{from, along.normalized(), along.norm() / kLengthMm, across};
}

Camera draw_camera(const PosedScene& posed, const SampleConfig& config, RandomStream& random) {
  const Eigen::Matrix3d rotation = draw_rotation(random);
  const double distance = random.uniform(config.nearest_m, config.farthest_m);
  const auto more = static_cast<std::uint64_t>(config.largest_px - config.smallest_px) + 1;
  const int side = config.smallest_px + static_cast<int>(random.below(more));
  return crop_camera(rotation, posed.center, distance, posed.hand_vertices, side);
}

bool shows_enough(const HandCrop& crop) {
  return std::ranges::count_if(crop.mask, [](std::uint8_t share) { return share > 127; }) >=
         kFewestPixels;
}

}  // namespace

std::optional<Sample> draw_picture(const SampleScene& scene, const SampleConfig& config,
                                   RandomStream& random) {
  const Camera camera = draw_camera(scene.posed, config, random);
  const Light light = draw_light(config, random);
  View view = rasterize(scene.posed.scene, camera, light);
  if (random.uniform() < config.occluders) hide_behind_object(view, random);
  const cv::Size size(view.label.width(), view.label.height());
  Paints paints;
  paints[kBackground] = draw_wall(size, random);
  paints[kObjectSurface] = draw_object(size, random);
  paints[kHandSurface] = draw_skin(size, config, random);
  if (random.uniform() < 0.35 * config.light) {
    paints[kHandSurface].patches += draw_shadow(size, light.softness, random);
  }
  GrayImage gray = painted(view, paints);
  photograph(gray, config, random);
  Mask mask = visible_hand(view);
  if (random.uniform() >= config.true_masks) {
    mask = found_mask(std::move(mask), arm_in_picture(camera, scene.towards_elbow), config, random);
  }
  const auto square = crop_square(mask);
  if (!square) return std::nullopt;
  Sample sample{.crop = crop_hand(gray, mask, *square)};
  if (!shows_enough(sample.crop)) return std::nullopt;
  sample.crop_from_hand =
      crop_from_camera(camera.intrinsics, *square) * camera.camera_from_hand.rotation;
  return sample;
}

}  // namespace graspdb
