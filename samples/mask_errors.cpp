// SPDX-License-Identifier: MIT
#include "mask_errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "graspdb/core/opencv/opencv_image.h"
#include "graspdb/core/transform.h"
#include "graspdb/features/segmentation.h"
#include "graspdb/sequences/noise.h"

namespace graspdb {
namespace {

constexpr double kCutMm = 15;           // beyond the wrist joint, where the forearm should end
constexpr double kArmHalfWidthMm = 60;  // what lies further to the side is not of the forearm
constexpr int kOutlineSide = 128;       // pixels: SampleConfig::outline_px is stated for it

void cut_arm(Mask& hand, const ArmInPicture& arm, double beyond_mm) {
  const double limit = beyond_mm * arm.px_per_mm;
  const double half_width = kArmHalfWidthMm * arm.px_per_mm_across;
  for (int y = 0; y < hand.height(); ++y) {
    for (int x = 0; x < hand.width(); ++x) {
      const Eigen::Vector2d from_wrist = Eigen::Vector2d(x, y) - arm.wrist;
      const double across = from_wrist.x() * arm.towards.y() - from_wrist.y() * arm.towards.x();
      if (from_wrist.dot(arm.towards) > limit && std::abs(across) < half_width) hand.at(x, y) = 0;
    }
  }
}

void paint(Mask& hand, const Mask& where, std::uint8_t value) {
  for (std::size_t i = 0; i < hand.size(); ++i) {
    if (where.data()[i] != 0) hand.data()[i] = value;
  }
}

// Pieces are lost to objects of the skin's colour, shade and light, and won from what lies behind.
void tear(Mask& hand, RandomStream& random) {
  const int pieces = 1 + static_cast<int>(random.below(3));
  for (int piece = 0; piece < pieces; ++piece) {
    const bool is_lost = random.uniform() < 0.6;
    const Mask where =
        draw_outline(hand.width(), hand.height(), Outline::kEllipse, 0.01, 0.10, random);
    // What is far from the hand is never taken for it.
    const bool touches = std::ranges::equal(
        where, hand, [](std::uint8_t a, std::uint8_t b) { return a == 0 || b == 0; });
    if (is_lost || !touches) paint(hand, where, is_lost ? 0 : 255);
  }
}

// Above 0: fatter.
void grow(Mask& hand, double by_px) {
  const int size = 2 * static_cast<int>(std::lround(std::abs(by_px))) + 1;
  if (size == 1) return;
  const cv::Mat image = as_mat(hand);
  const cv::Mat disk = cv::getStructuringElement(cv::MORPH_ELLIPSE, {size, size});
  if (by_px > 0) {
    cv::dilate(image, image, disk);
  } else {
    cv::erode(image, image, disk);
  }
}

// What the tracker makes of a mask. It finds a hand in nearly all of these.
Mask isolated(const Mask& hand) {
  Mask isolated = isolate_hand(hand, {}, {.min_area_px = 1});
  return is_empty(isolated) ? hand : isolated;
}

// As large as a hand is in a frame of 640 x 480: noise is stated in the frame's pixels.
constexpr int kFrameSide = 200;

Mask noisy(const Mask& hand, double percent, std::uint64_t seed) {
  const int factor = (kFrameSide + hand.width() - 1) / hand.width();
  const Mask large = resized(hand, hand.width() * factor, hand.height() * factor);
  const Mask noisy = add_segmentation_noise(large, percent, seed, 0);
  return resized(isolated(noisy), hand.width(), hand.height());
}

}  // namespace

Mask draw_outline(int width, int height, Outline outline, double smallest, double largest,
                  RandomStream& random) {
  const auto half_axis = [&] {
    return static_cast<float>(random.uniform(smallest, largest) * width) + 1;
  };
  const auto x = static_cast<float>(random.uniform(0, width));
  const auto y = static_cast<float>(random.uniform(0, height));
  const cv::Size2f axes(2 * half_axis(), 2 * half_axis());
  const cv::RotatedRect where({x, y}, axes, static_cast<float>(random.uniform(0, 180)));
  Mask mask(width, height);
  const cv::Mat image = as_mat(mask);
  if (outline == Outline::kEllipse) {
    cv::ellipse(image, where, {255}, cv::FILLED);
    return mask;
  }
  std::array<cv::Point2f, 4> corners;
  where.points(corners.data());
  const std::vector<cv::Point> polygon(corners.begin(), corners.end());
  cv::fillConvexPoly(image, polygon, {255});
  return mask;
}

Mask found_mask(Mask hand, const std::optional<ArmInPicture>& arm, const SampleConfig& config,
                RandomStream& random) {
  const bool is_cut = random.uniform() < 0.7 && config.wrist_cut_mm > 0;
  const double cut_mm = kCutMm + config.wrist_cut_mm * std::clamp(random.normal() / 2, -1.0, 1.0);
  if (is_cut && arm) cut_arm(hand, *arm, cut_mm);
  const double share = random.uniform(),
               noise = random.uniform() < 0.4 ? share * share * config.noise_percent : 0;
  const bool is_torn = random.uniform() < config.torn;
  const double fatter = config.outline_px * random.uniform(-1, 1);
  if (is_torn) tear(hand, random);
  grow(hand, fatter * hand.width() / kOutlineSide);
  const std::uint64_t seed = random.bits();
  return noise > 0 ? noisy(hand, noise, seed) : isolated(hand);
}

}  // namespace graspdb
