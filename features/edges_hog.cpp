// SPDX-License-Identifier: MIT
// A descriptor of outlines and strong inner edges: see HogMode::kEdges.
#include <algorithm>
#include <array>
#include <cmath>

#include "hog_modes.h"

namespace graspdb {
namespace {

constexpr int kSide = 64;
constexpr int kCellSide = kSide / kCells;
// An outline across a cell, side to side, counts about as much.
constexpr float kFullVotes = kCellSide;

// A 64 x 64 picture with a frame of zeros.
constexpr int kStride = kSide + 2;
using Canvas = std::array<float, kStride * kStride>;

constexpr std::size_t index_of(int x, int y) {
  return static_cast<std::size_t>((y + 1) * kStride + x + 1);
}

// The part of a source axis of `length` pixels under each of the 64 target pixels: `share` of the
// first and last, all of those between.
struct Span {
  int first, last;
  float first_share, last_share;
};

std::array<Span, kSide> spans_of(int length) {
  std::array<Span, kSide> spans{};
  for (int i = 0; i < kSide; ++i) {
    // In 64ths of a source pixel, so that all is whole numbers.
    const int begin = i * length, end = (i + 1) * length;
    const int first = begin / kSide, last = (end - 1) / kSide;
    const int first_end = std::min((first + 1) * kSide, end);
    const float scale = 1.0F / static_cast<float>(length);
    spans[static_cast<std::size_t>(i)] = {
        first, last, static_cast<float>(first_end - begin) * scale,
        last > first ? static_cast<float>(end - last * kSide) * scale : 0.0F};
  }
  return spans;
}

// Mean coverage by the mask and mean masked grey under each pixel of the 64 x 64 picture.
struct Resampled {
  Canvas coverage{};
  Canvas grey{};
};

struct RowSums {
  std::array<float, kSide> coverage, grey;
};

RowSums sum_row(const std::uint8_t* grey, const std::uint8_t* inside,
                const std::array<Span, kSide>& spans, int length) {
  RowSums sums;
  const float whole = static_cast<float>(kSide) / static_cast<float>(length);
  for (std::size_t i = 0; i < kSide; ++i) {
    const Span& span = spans[i];
    const auto sample = [&](int x) { return inside[x] != 0 ? int{grey[x]} : 0; };
    int inner_grey = 0, inner_count = 0;
    for (int x = span.first + 1; x < span.last; ++x) {
      inner_grey += sample(x);
      inner_count += inside[x] != 0;
    }
    sums.grey[i] = span.first_share * static_cast<float>(sample(span.first)) +
                   span.last_share * static_cast<float>(sample(span.last)) +
                   whole * static_cast<float>(inner_grey);
    sums.coverage[i] = span.first_share * static_cast<float>(inside[span.first] != 0) +
                       span.last_share * static_cast<float>(inside[span.last] != 0) +
                       whole * static_cast<float>(inner_count);
  }
  return sums;
}

Resampled resample(const GrayImage& gray, const Mask& mask, const Box& box) {
  const std::array<Span, kSide> columns = spans_of(box.width), rows = spans_of(box.height);
  const float whole = static_cast<float>(kSide) / static_cast<float>(box.height);
  Resampled out;
  RowSums sums{};
  int summed = -1;
  for (int i = 0; i < kSide; ++i) {
    const Span& span = rows[static_cast<std::size_t>(i)];
    for (int y = span.first; y <= span.last; ++y) {
      if (y != summed) {
        sums =
            sum_row(gray.row(box.y + y) + box.x, mask.row(box.y + y) + box.x, columns, box.width);
        summed = y;
      }
      const float share = y == span.first  ? span.first_share
                          : y == span.last ? span.last_share
                                           : whole;
      for (int x = 0; x < kSide; ++x) {
        out.coverage[index_of(x, i)] += share * sums.coverage[static_cast<std::size_t>(x)];
        out.grey[index_of(x, i)] += share * sums.grey[static_cast<std::size_t>(x)];
      }
    }
  }
  return out;
}

// The hand's brightness relative to its mean; where there is no hand, that mean, so that the
// outline makes no edge here.
Canvas relative_brightness(const Resampled& picture) {
  float grey = 0, coverage = 0;
  for (std::size_t i = 0; i < picture.grey.size(); ++i) {
    grey += picture.grey[i];
    coverage += picture.coverage[i];
  }
  const float mean = std::max(grey / coverage, 1.0F);
  Canvas brightness;
  for (std::size_t i = 0; i < brightness.size(); ++i) {
    const float covered = picture.coverage[i];
    brightness[i] = covered > 0 ? picture.grey[i] / (covered * mean) : 1.0F;
  }
  return brightness;
}

struct Gradient {
  float x, y;
};

// Sobel's, a pixel being the unit of length.
Gradient gradient_at(const Canvas& c, std::size_t i) {
  const float* p = c.data() + i;
  const float left = p[-kStride - 1] + 2 * p[-1] + p[kStride - 1];
  const float right = p[-kStride + 1] + 2 * p[1] + p[kStride + 1];
  const float top = p[-kStride - 1] + 2 * p[-kStride] + p[-kStride + 1];
  const float bottom = p[kStride - 1] + 2 * p[kStride] + p[kStride + 1];
  return {(right - left) / 8, (bottom - top) / 8};
}

// The gradient's direction modulo 180 degrees in bins, 0..8; a bin's centre is a whole number, so
// that upright and level outlines do not lie between two.
float orientation(const Gradient& g) {
  const float across = std::abs(g.x), down = std::abs(g.y);
  const float slope = std::min(across, down) / std::max(across, down);
  // atan(slope) to 0.004 radians, in bins of pi / 8.
  const float octant = slope * (2 + 0.695F * (1 - slope));
  const float quadrant = across >= down ? octant : 4 - octant;
  return (g.x < 0) == (g.y < 0) ? quadrant : 8 - quadrant;
}

using Votes = std::array<float, kDescriptorSize>;

void vote(const Gradient& g, float weight, float* bins) {
  if (weight <= 0) return;
  const float position = orientation(g);
  const int bin = static_cast<int>(position);
  const float upper = position - static_cast<float>(bin);
  bins[bin % kBins] += weight * (1 - upper);
  bins[(bin + 1) % kBins] += weight * upper;
}

// The contrast of noise and of gentle shading does not count, and a shadow's no more than this.
// Chosen by retrieving views of another hand in other light.
float inner_weight(float contrast) {
  constexpr float kFaint = 0.03F, kMost = 0.15F, kGain = 2;
  return kGain * std::clamp(contrast - kFaint, 0.0F, kMost);
}

float length(const Gradient& g) {
  return std::sqrt(g.x * g.x + g.y * g.y);
}

// An inner edge counts only where all nine pixels that its gradient looks at are mostly hand.
bool well_inside(const Canvas& coverage, std::size_t i) {
  const float* p = coverage.data() + i;
  float least = 1;
  for (int row = -kStride; row <= kStride; row += kStride) {
    least = std::min({least, p[row - 1], p[row], p[row + 1]});
  }
  return least > 0.5F;
}

}  // namespace

Descriptor describe_edges(const GrayImage& gray, const Mask& mask, const Box& box) {
  const Resampled picture = resample(gray, mask, box);
  const Canvas brightness = relative_brightness(picture);
  Votes votes{};
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const std::size_t i = index_of(x, y);
      float* bins = votes.data() + ((y / kCellSide) * kCells + x / kCellSide) * kBins;
      const Gradient outline = gradient_at(picture.coverage, i);
      vote(outline, length(outline), bins);
      if (!well_inside(picture.coverage, i)) continue;
      const Gradient inner = gradient_at(brightness, i);
      vote(inner, inner_weight(length(inner)), bins);
    }
  }
  Descriptor descriptor;
  for (std::size_t i = 0; i < votes.size(); ++i) {
    const float share = std::min(votes[i] / kFullVotes, 1.0F);
    descriptor[i] = static_cast<std::uint8_t>(255 * std::sqrt(share) + 0.5F);
  }
  return descriptor;
}

}  // namespace graspdb
