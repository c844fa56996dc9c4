// SPDX-License-Identifier: MIT
#include "wrist_colors.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "frame_parts.h"
#include "graspdb/core/opencv/opencv_image.h"

namespace graspdb {
namespace {

// Bins of brightness, which differs much over a hand, and of the two differences from grey.
constexpr std::size_t kLumaBins = 4, kChromaBins = 32;
constexpr std::size_t kBins = kLumaBins * kChromaBins * kChromaBins;
// Each sample counts as so many more of its own size, spread over all bins: what has hardly been
// seen proves nothing.
constexpr std::int64_t kUnseen = 20;
constexpr std::int64_t kBlurred = 64;  // what one cell counts after blurred()
constexpr int kFewestCells = 4;        // of hand: fewer show no colour
constexpr int kSmallestArm = 6;        // cells
constexpr float kNearestWrist = 3;     // cells
constexpr int kMostEvidence = 24;      // in the steps of PartCells: e^3 to 1

using Counts = std::vector<std::int64_t>;

// [1 2 1] along one axis, of which neighbours are `stride` apart.
Counts blurred_along(const Counts& counts, std::size_t stride, std::size_t length) {
  Counts blurred(counts.size());
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const std::size_t at = i / stride % length;
    blurred[i] = 2 * counts[i];
    if (at > 0) blurred[i] += counts[i - stride];
    if (at + 1 < length) blurred[i] += counts[i + stride];
  }
  return blurred;
}

Counts blurred(const Counts& counts) {
  const Counts once = blurred_along(counts, 1, kChromaBins);
  const Counts twice = blurred_along(once, kChromaBins, kChromaBins);
  return blurred_along(twice, kChromaBins * kChromaBins, kLumaBins);
}

struct Sample {
  Counts counts = Counts(kBins);
  std::int64_t cells = 0;

  void add(std::size_t bin) {
    ++counts[bin];
    ++cells;
  }
};

// The logarithm to base 2 of a positive number, in sixteenths. In whole numbers: masks are the same
// on every processor.
int log2_in_sixteenths(std::uint64_t value) {
  const int whole = static_cast<int>(std::bit_width(value)) - 1;
  std::uint64_t rest = whole > 31 ? value >> (whole - 31) : value << (31 - whole);  // 2^31 is 1
  int result = whole;
  for (int bit = 0; bit < 4; ++bit) {
    rest = rest * rest >> 31;
    result *= 2;
    if (rest >> 32 == 0) continue;
    rest >>= 1;
    ++result;
  }
  return result;
}

// In the steps of PartCells, eighths of a natural logarithm.
int steps_of(int log2_sixteenths) {
  constexpr int kStepsOf1024 = 355;  // 1024 * ln 2 / 2
  return std::clamp(log2_sixteenths * kStepsOf1024 / 1024, -kMostEvidence, kMostEvidence);
}

// How much likelier each bin's colours are of the one sample than of the other.
std::vector<int> evidence(const Sample& hand, const Sample& rest) {
  const std::int64_t rest_cells = std::max<std::int64_t>(rest.cells, 1);
  const Counts in_hand = blurred(hand.counts), in_rest = blurred(rest.counts);
  const auto kEach = static_cast<std::int64_t>(kBins);
  const std::int64_t unseen = kUnseen * kBlurred * hand.cells * rest_cells;
  std::vector<int> steps(kBins);
  for (std::size_t i = 0; i < kBins; ++i) {
    const auto of_hand = static_cast<std::uint64_t>(kEach * in_hand[i] * rest_cells + unseen);
    const auto of_rest = static_cast<std::uint64_t>(kEach * in_rest[i] * hand.cells + unseen);
    steps[i] = steps_of(log2_in_sixteenths(of_hand) - log2_in_sixteenths(of_rest));
  }
  return steps;
}

std::vector<std::size_t> bins_of(const ColorImage& colors) {
  cv::Mat converted;
  cv::cvtColor(as_mat(colors), converted, cv::COLOR_BGR2YCrCb);
  std::vector<std::size_t> bins;
  bins.reserve(colors.size());
  for (auto it = converted.begin<cv::Vec3b>(); it != converted.end<cv::Vec3b>(); ++it) {
    const cv::Vec3b& color = *it;
    bins.push_back((color[0] / 64U * kChromaBins + color[1] / 8U) * kChromaBins + color[2] / 8U);
  }
  return bins;
}

// The cells that are no further from the arm than half of its width; all without an arm.
cv::Mat near_the_wrist(const FrameParts& parts) {
  const Mask hand = grown(grown(cells_of(parts, {&FrameParts::hand})));
  const Mask arms = arms_of(hand, Regions(cells_of(parts, {&FrameParts::arm})), kSmallestArm);
  const cv::Mat arm = as_mat(arms);
  if (cv::countNonZero(arm) == 0) return cv::Mat(arm.size(), CV_8U, cv::Scalar(255));
  cv::Mat depth, distance;
  double half_width = 0;
  cv::distanceTransform(arm, depth, cv::DIST_L2, cv::DIST_MASK_3);
  cv::minMaxLoc(depth, nullptr, &half_width);
  cv::distanceTransform(~arm, distance, cv::DIST_L2, cv::DIST_MASK_3);
  return distance <= std::max(kNearestWrist, static_cast<float>(half_width));
}

}  // namespace

void weigh_colors(FrameParts& parts) {
  const std::vector<std::size_t> bins = bins_of(parts.color);
  const cv::Mat near = near_the_wrist(parts);
  Sample hand, rest;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    const bool is_hand = parts.hand.data()[i] >= kLikeAnyOther;
    const bool is_arm = parts.arm.data()[i] >= kLikeAnyOther;
    if (is_hand && near.data[i] != 0) hand.add(bins[i]);
    if (!is_hand && !is_arm) rest.add(bins[i]);
  }
  if (hand.cells < kFewestCells) return;
  const std::vector<int> steps = evidence(hand, rest);
  for (std::size_t i = 0; i < bins.size(); ++i) {
    const bool is_arm = parts.arm.data()[i] >= kLikeAnyOther;
    std::uint8_t& like = parts.hand.data()[i];
    const int weighed = like + (is_arm ? std::min(steps[bins[i]], 0) : steps[bins[i]]);
    like = static_cast<std::uint8_t>(std::clamp(weighed, 0, 255));
  }
}

}  // namespace graspdb
