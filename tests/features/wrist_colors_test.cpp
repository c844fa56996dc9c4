// SPDX-License-Identifier: MIT
#include "wrist_colors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "graspdb/core/random.h"

namespace graspdb {
namespace {

constexpr Bgr kSkinTone = {110, 140, 200}, kPrint = {200, 60, 40}, kPlaster = {90, 100, 95};
constexpr std::uint8_t kLikely = 160, kUnlikely = 100;

// An arm comes up from below; above it a hand of 8 x 8 cells; 10 cells of a print further up that
// the net takes for hand, too; a finger that it has missed on the left.
FrameParts printed_box() {
  FrameParts parts;
  parts.color = ColorImage(40, 40, kPlaster);
  parts.hand = parts.arm = parts.object = PartCells(40, 40, kUnlikely);
  const auto fill = [&](const Box& box, const Bgr& color, PartCells* part) {
    for (int y = box.y; y < box.y + box.height; ++y) {
      for (int x = box.x; x < box.x + box.width; ++x) {
        parts.color.at(x, y) = color;
        if (part != nullptr) part->at(x, y) = kLikely;
      }
    }
  };
  fill({16, 30, 8, 10}, kSkinTone, &parts.arm);
  fill({16, 22, 8, 8}, kSkinTone, &parts.hand);
  fill({10, 10, 10, 10}, kPrint, &parts.hand);
  fill({6, 22, 2, 8}, kSkinTone, nullptr);
  return parts;
}

TEST(WristColors, APrintThatIsTakenForFingersFallsAndAMissedFingerRises) {
  FrameParts parts = printed_box();
  for (int x = 10; x < 20; ++x) parts.object.at(x, 9) = kLikely;
  for (int x = 10; x < 20; ++x) parts.color.at(x, 9) = kPrint;
  weigh_colors(parts);
  EXPECT_LT(parts.hand.at(15, 15), kLikely);
  EXPECT_GT(parts.hand.at(18, 25), kLikely);
  EXPECT_GT(parts.hand.at(6, 25), kUnlikely);
  EXPECT_LT(parts.hand.at(2, 2), kUnlikely);  // the wall
}

TEST(WristColors, ArmsStayArms) {
  FrameParts parts = printed_box();
  weigh_colors(parts);
  EXPECT_EQ(parts.hand.at(20, 35), kUnlikely);
  EXPECT_EQ(parts.arm, printed_box().arm);
  EXPECT_EQ(parts.object, printed_box().object);
}

TEST(WristColors, WithoutAnArmAllOfTheHandTellsItsColors) {
  FrameParts parts = printed_box();
  std::ranges::fill(parts.arm, kUnlikely);
  weigh_colors(parts);
  EXPECT_GT(parts.hand.at(15, 15), kLikely);  // what is most of the hand cannot be told from it
  EXPECT_GT(parts.hand.at(6, 25), kUnlikely);
}

TEST(WristColors, OfAFewCellsNothingIsLearned) {
  FrameParts parts = printed_box();
  std::ranges::fill(parts.hand, kUnlikely);
  for (int x = 0; x < 3; ++x) parts.hand.at(x, 0) = kLikely;
  const PartCells before = parts.hand;
  weigh_colors(parts);
  EXPECT_EQ(parts.hand, before);
}

// How often a colour's bin and those around it are seen, as blurred [1 2 1] / 4 along each axis.
double plain_share(const FrameParts& parts, const std::vector<bool>& chosen, int y, int r, int b) {
  double sum = 0, all = 0;
  for (std::size_t i = 0; i < parts.color.size(); ++i) {
    if (!chosen[i]) continue;
    ++all;
    const Bgr& color = parts.color.data()[i];
    const double luma = std::round(0.299 * color[2] + 0.587 * color[1] + 0.114 * color[0]);
    const int red = static_cast<int>(std::round((color[2] - luma) * 0.713 + 128)) / 8;
    const int blue = static_cast<int>(std::round((color[0] - luma) * 0.564 + 128)) / 8;
    const auto near = [](int distance) { return distance > 1 ? 0. : distance == 1 ? .25 : .5; };
    sum += near(std::abs(static_cast<int>(luma) / 64 - y)) * near(std::abs(red - r)) *
           near(std::abs(blue - b));
  }
  return sum / std::max(all, 1.);
}

TEST(WristColors, EvidenceIsTheLogarithmOfTheSharesOfAColor) {
  RandomStream random(7);
  FrameParts parts = printed_box();
  std::ranges::fill(parts.arm, kUnlikely);
  for (std::size_t i = 0; i < parts.color.size(); ++i) {  // hands are darker
    const bool is_hand = parts.hand.data()[i] >= 128;
    const auto gray = static_cast<std::uint8_t>(32 + 64 * random.below(is_hand ? 2 : 4));
    parts.color.data()[i] = {gray, gray, gray};  // well within its bin, however it is rounded
  }
  const FrameParts before = parts;
  weigh_colors(parts);
  std::vector<bool> hand, rest;
  for (const std::uint8_t like : before.hand) hand.push_back(like >= 128);
  for (const bool is_hand : hand) rest.push_back(!is_hand);
  for (std::size_t i = 0; i < hand.size(); ++i) {
    const int luma = before.color.data()[i][0] / 64;
    const double unseen = 20. / (4 * 32 * 32);
    const double ratio = (plain_share(before, hand, luma, 16, 16) + unseen) /
                         (plain_share(before, rest, luma, 16, 16) + unseen);
    EXPECT_NEAR(parts.hand.data()[i] - before.hand.data()[i], 8 * std::log(ratio), 1.5) << luma;
  }
}

}  // namespace
}  // namespace graspdb
