// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstring>
#include <opencv2/imgproc.hpp>

#include "graspdb/core/error.h"
#include "graspdb/core/opencv/opencv_image.h"
#include "graspdb/features/hog.h"
#include "graspdb/features/segmentation.h"
#include "plausible.h"
#include "regions.h"

namespace graspdb {
namespace {

// Half the side of the vote below, as a share of the square root of the hand's area: a pixel or two
// for a hand 100 pixels wide.
constexpr double kSmoothing = 0.02;
// Votes follow each other until so few pixels change, as a share of that area: one or two, and more
// where noise has torn the mask.
constexpr double kSettled = 0.005;
constexpr int kMostVotes = 10;

// Every pixel becomes what most of its neighbours are. How many change.
int vote(cv::Mat mask, int radius) {
  cv::Mat votes;
  cv::blur(mask, votes, {2 * radius + 1, 2 * radius + 1}, {-1, -1}, cv::BORDER_REPLICATE);
  cv::threshold(votes, votes, 127, 255, cv::THRESH_BINARY);
  const int changed = cv::countNonZero(mask != votes);
  votes.copyTo(mask);
  return changed;
}

// Specks, pinholes and the frayed edges of a segmentation go, what it has torn is joined, holes as
// large as an object stay.
void smooth(Mask& hand) {
  const auto area = static_cast<double>(std::count(hand.begin(), hand.end(), 255));
  const int radius = static_cast<int>(std::lround(kSmoothing * std::sqrt(area)));
  const std::optional<Box> box = tight_box(hand);
  if (radius == 0 || !box) return;
  const cv::Mat image = as_mat(hand)(grown(*box, radius, hand));
  for (int votes = 0; votes < kMostVotes && vote(image, radius) > kSettled * area; ++votes) {
  }
}

// The object that a hand holds can cut it into pieces. Those of the skin's other regions count that
// are more than specks and no further from the largest, which may show but half of the hand, than a
// hand is long. What comes in from the picture's border is another arm.
constexpr double kSmallestPiece = 0.005;  // of the largest region's area
constexpr double kWidestGap = 3;          // in square roots of that area

bool touches_border(const Box& box, const Mask& mask) {
  return box.x == 0 || box.y == 0 || box.x + box.width == mask.width() ||
         box.y + box.height == mask.height();
}

bool is_piece(const Region& region, const Region& largest, const Mask& mask) {
  return region.area_px >= kSmallestPiece * largest.area_px && !touches_border(region.box, mask) &&
         gap_between(region.box, largest.box) <= kWidestGap * std::sqrt(largest.area_px);
}

// Skin is looked for in a picture of no more pixels than these: a hand still has thousands.
constexpr double kMostPixels = 110'000;

// Of the frame's width and height.
int shrink_factor(const ColorImage& frame) {
  return static_cast<int>(std::ceil(std::sqrt(static_cast<double>(frame.size()) / kMostPixels)));
}

ColorImage shrink(const ColorImage& frame, int factor) {
  ColorImage small((frame.width() + factor - 1) / factor, (frame.height() + factor - 1) / factor);
  cv::Mat image = as_mat(small);
  cv::resize(as_mat(frame), image, image.size(), 0, 0, cv::INTER_LINEAR);
  return small;
}

// The pixels that hold some of the box.
Box shrink(const Box& box, int factor) {
  const int right = box.x + box.width, bottom = box.y + box.height;
  const int x = box.x / factor, y = box.y / factor;
  return {x, y, (right + factor - 1) / factor - x, (bottom + factor - 1) / factor - y};
}

// Of the mask's pixels, and how many there are.
struct Middle {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  double pixels = 0;
};

Middle middle_of(const Mask& mask) {
  Middle middle;
  const auto width = static_cast<std::size_t>(mask.width());
  for (int y = 0; y < mask.height(); ++y) {
    const std::uint8_t* row = mask.row(y);
    const void* first = std::memchr(row, 255, width);  // most rows have none
    if (first == nullptr) continue;
    for (auto x = static_cast<const std::uint8_t*>(first) - row; x < mask.width(); ++x) {
      if (row[x] == 0) continue;
      middle.place += Eigen::Vector2d(static_cast<double>(x), y);
      ++middle.pixels;
    }
  }
  middle.place /= std::max(middle.pixels, 1.0);
  return middle;
}

constexpr double kLeastArm = 0.03;  // of the hand's pixels

}  // namespace

std::optional<Eigen::Vector2d> arm_direction(const FoundHand& found) {
  const Middle arm = middle_of(found.arm);
  if (arm.pixels == 0) return std::nullopt;
  const Middle hand = middle_of(found.hand);
  if (hand.pixels == 0 || arm.pixels < kLeastArm * hand.pixels) return std::nullopt;
  const Eigen::Vector2d way = arm.place - hand.place;
  return way.norm() > 0 ? std::optional<Eigen::Vector2d>(way.normalized()) : std::nullopt;
}

Mask resized(const Mask& mask, int width, int height) {
  Mask result(width, height);
  const std::optional<Box> box = tight_box(mask);
  if (!box) return result;
  const cv::Mat from = as_mat(mask), to = as_mat(result);
  const cv::Size factor(width / mask.width(), height / mask.height());
  cv::Rect part({0, 0}, from.size()), part_of_result({0, 0}, to.size());
  if (factor.width * mask.width() == width && factor.height * mask.height() == height) {
    part = grown(*box, 1, mask);  // the rest stays empty
    part_of_result = {part.x * factor.width, part.y * factor.height, part.width * factor.width,
                      part.height * factor.height};
  }
  cv::Mat image = to(part_of_result);
  cv::resize(from(part), image, image.size(), 0, 0, cv::INTER_LINEAR);
  cv::threshold(image, image, 127, 255, cv::THRESH_BINARY);
  return result;
}

FoundHand split_hand(const Mask& skin, const std::optional<Box>& roi, const SkinOptions& options) {
  const Mask nothing(skin.width(), skin.height());
  Mask smoothed = skin, hand = nothing;
  smooth(smoothed);
  const Regions regions(smoothed);
  const auto largest = regions.largest(options.min_area_px, roi);
  if (!largest) return {nothing, nothing};
  for (std::size_t i = 0; i < regions.all().size(); ++i) {
    if (i == *largest || is_piece(regions.all()[i], regions.all()[*largest], hand))
      regions.paint(i, hand);
  }
  if (!has_shape_of_hand(hand)) return {nothing, nothing};
  FoundHand found{cut_forearm(hand), std::move(hand)};
  std::ranges::transform(
      found.arm, found.hand, found.arm.begin(),
      [](std::uint8_t all, std::uint8_t is_hand) { return is_hand != 0 ? std::uint8_t{0} : all; });
  return found;
}

Mask isolate_hand(const Mask& skin, const std::optional<Box>& roi, const SkinOptions& options) {
  return split_hand(skin, roi, options).hand;
}

FoundHand find_by_color(const ColorImage& frame, const std::optional<Box>& roi,
                        const SkinOptions& options) {
  GRASPDB_CHECK(!frame.empty());
  const int factor = shrink_factor(frame);
  const ColorImage small = shrink(frame, factor);
  SkinOptions of_small = options;
  of_small.min_area_px /= factor * factor;
  const std::optional<Mask> region =
      largest_region(segment_skin(small, of_small), of_small.min_area_px,
                     roi ? std::optional(shrink(*roi, factor)) : std::nullopt);
  const Mask nothing(frame.width(), frame.height());
  if (!region || !has_color_of_skin(small, *region)) return {nothing, nothing};
  FoundHand found = split_hand(*region, {}, of_small);
  if (factor == 1) return found;
  const auto as_frame = [&](const Mask& mask) {
    return resized(mask, frame.width(), frame.height());
  };
  return {as_frame(found.hand), as_frame(found.arm)};
}

}  // namespace graspdb
