// SPDX-License-Identifier: MIT
// Finds the hand in a camera frame.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "graspdb/core/image.h"

namespace graspdb {

// How skin is told from the rest.
enum class SkinRule {
  // Redder than the frame's own threshold: the a* of CIE Lab, split by Otsu's method. While the
  // redder side fills more of the frame than a hand does, it is split again. Follows the light of
  // the room: on photographs in warm and cold light its regions agree with hand-drawn masks better
  // than any fixed box.
  kRedness,
  // A fixed box in HSV, as the paper has it.
  kBox,
};

struct SkinOptions {
  SkinRule rule = SkinRule::kRedness;
  double max_share = 0.4;  // kRedness: of the frame, above which it is split again
  int min_redness = 2;     // kRedness: a* that skin exceeds in any light; a grey wall has 0
  // kBox, in OpenCV's 8-bit units; hue is 0..179 and wraps around.
  int hue_mean = 10, hue_range = 10;
  int saturation_mean = 133, saturation_range = 123;
  int value_mean = 129, value_range = 127;
  int min_area_px = 1000;  // smaller regions are no hand
};

// All skin-coloured pixels after a 3x3 closing. Pure; thread-safe.
Mask segment_skin(const ColorImage& frame, const SkinOptions& options = {});

// The largest connected region (of 8 neighbours) of the mask with at least min_area_px pixels, of
// which one or more lie in `roi` (the whole picture when absent); the others are cleared. None when
// there is no such region.
std::optional<Mask> largest_region(const Mask& mask, int min_area_px,
                                   const std::optional<Box>& roi = {});

// Cuts a bare forearm off. Where an arm enters from the picture's border, what lies on its way is
// cleared up to some 15 mm before the wrist joint. Along the arm, measured by the radius of the
// largest inscribed circle, the palm is the widening after the narrowest place that is not too far
// from the fingertips; lengths are counted in its radius, about 40 mm, or the arm's. Seen edge-on a
// palm hardly widens: there the cut may err by 40 mm to either side. A mask that does not touch the
// border over an arm's width is returned unchanged, as is one that shows no forearm. What
// is not connected with the arm stays.
Mask cut_forearm(const Mask& hand);

// The hand in a mask: of the smoothed mask the region of largest_region and the pieces around it
// that an object before the hand has cut off, without the forearm. All 0 when there is none, or
// when its outline or its share of the picture's border is none of a hand with its arm.
Mask isolate_hand(const Mask& skin, const std::optional<Box>& roi = {},
                  const SkinOptions& options = {});

struct FoundHand {
  Mask hand;  // all 0 when there is none; pieces on all sides of a held object
  Mask arm;   // what is seen of its forearm and sleeve
};
// As isolate_hand, with what is cut off.
FoundHand split_hand(const Mask& skin, const std::optional<Box>& roi = {},
                     const SkinOptions& options = {});

// From the middle of the hand to that of its arm, in the picture, of length 1; none when hardly
// any arm is seen.
std::optional<Eigen::Vector2d> arm_direction(const FoundHand& found);

// The largest region of segment_skin, split as split_hand() does, but without pieces around it:
// what is near a hand and of its colour is more often something else. Nothing when there is no
// region, or when its hue or the spread of its redness is none of skin. A frame of more than
// 110,000 pixels is shrunk for that, so that the outlines are those of pixels twice as wide in one
// of 640 x 480; `roi` and min_area_px are in the frame's pixels all the same.
FoundHand find_by_color(const ColorImage& frame, const std::optional<Box>& roi = {},
                        const SkinOptions& options = {});

// The mask with another number of pixels, cut at half.
Mask resized(const Mask& mask, int width, int height);

// Whether it shows no hand.
bool is_empty(const Mask& mask);

// Whether more than one pixel in a thousand is clearly none of grey's; else no skin can be told.
bool has_color(const ColorImage& frame);

// Rec. 601 luma.
GrayImage to_gray(const ColorImage& frame);

}  // namespace graspdb
