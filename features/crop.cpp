// SPDX-License-Identifier: MIT
#include "graspdb/features/crop.h"

#include <algorithm>
#include <numeric>

#include "graspdb/core/error.h"
#include "graspdb/features/hog.h"

namespace graspdb {
namespace {

constexpr int kMarginPercent = 8;  // of the side, half of it at either end
constexpr int kLongestSide = 1 << 14;

// Lengths are counted in 128ths of a picture's pixel, so that all of them are whole.
constexpr int kUnit = 2 * kCropSide;

// The picture's pixels under one of the crop's, along one axis: `first_share` of the first and
// `last_share` of the last, all of those between. None when `last` is before `first`.
struct CropSpan {
  int first = 0, last = -1;
  std::uint32_t first_share = 0, last_share = 0;
};

using CropSpans = std::array<CropSpan, kCropSide>;

CropSpan span_between(int begin, int end) {
  CropSpan span{.first = begin / kUnit, .last = (end - 1) / kUnit};
  span.first_share = static_cast<std::uint32_t>(std::min((span.first + 1) * kUnit, end) - begin);
  if (span.last > span.first) {
    span.last_share = static_cast<std::uint32_t>(end - span.last * kUnit);
  }
  return span;
}

CropSpans crop_spans(int corner_x2, int side, int length) {
  CropSpans spans;
  for (int i = 0; i < kCropSide; ++i) {
    const int begin = std::max(corner_x2 * kCropSide + i * 2 * side, 0);
    const int end = std::min(corner_x2 * kCropSide + (i + 1) * 2 * side, length * kUnit);
    if (begin < end) spans[static_cast<std::size_t>(i)] = span_between(begin, end);
  }
  return spans;
}

struct CropRowSums {
  std::array<std::uint32_t, kCropSide> gray, mask, scene;
};

CropRowSums sum_crop_row(const std::uint8_t* gray, const std::uint8_t* mask,
                         const CropSpans& columns) {
  CropRowSums sums{};
  for (std::size_t i = 0; i < kCropSide; ++i) {
    const CropSpan& span = columns[i];
    const auto add = [&](int x, std::uint32_t share) {
      const std::uint32_t inside = mask[x] != 0;
      sums.scene[i] += share * gray[x];
      sums.gray[i] += share * inside * gray[x];
      sums.mask[i] += share * inside;
    };
    if (span.last < span.first) continue;
    add(span.first, span.first_share);
    for (int x = span.first + 1; x < span.last; ++x) add(x, kUnit);
    if (span.last > span.first) add(span.last, span.last_share);
  }
  return sums;
}

struct PlaneSums {
  std::array<std::uint64_t, kCropPixels> gray{}, mask{}, scene{};
};

void add_row(const CropRowSums& sums, std::uint32_t share, std::size_t row, PlaneSums& planes) {
  for (std::size_t x = 0; x < kCropSide; ++x) {
    const std::size_t at = row * kCropSide + x;
    planes.gray[at] += std::uint64_t{share} * sums.gray[x];
    planes.mask[at] += std::uint64_t{share} * sums.mask[x];
    planes.scene[at] += std::uint64_t{share} * sums.scene[x];
  }
}

PlaneSums sum_square(const GrayImage& gray, const Mask& mask, const CropSquare& square) {
  const CropSpans columns = crop_spans(square.left_x2, square.side, gray.width());
  const CropSpans rows = crop_spans(square.top_x2, square.side, gray.height());
  PlaneSums planes;
  CropRowSums sums{};
  int summed = -1;  // two of the crop's rows may share one of the picture's
  for (std::size_t i = 0; i < kCropSide; ++i) {
    const CropSpan& span = rows[i];
    for (int y = span.first; y <= span.last; ++y) {
      if (y != summed) sums = sum_crop_row(gray.row(y), mask.row(y), columns);
      summed = y;
      const bool is_end = y == span.first || y == span.last;
      const std::uint32_t end_share = y == span.first ? span.first_share : span.last_share;
      add_row(sums, is_end ? end_share : kUnit, i, planes);
    }
  }
  return planes;
}

CropPlane scaled(const std::array<std::uint64_t, kCropPixels>& sums, double factor) {
  CropPlane plane;
  std::ranges::transform(sums, plane.begin(), [factor](std::uint64_t sum) {
    return static_cast<std::uint8_t>(std::min(static_cast<double>(sum) * factor + 0.5, 255.0));
  });
  return plane;
}

double total(const std::array<std::uint64_t, kCropPixels>& sums) {
  return static_cast<double>(std::accumulate(sums.begin(), sums.end(), std::uint64_t{0}));
}

}  // namespace

Eigen::Vector2d CropSquare::middle() const {
  return {(left_x2 + side - 1) / 2.0, (top_x2 + side - 1) / 2.0};
}

std::optional<CropSquare> crop_square(const Mask& mask) {
  const std::optional<Box> box = tight_box(mask);
  if (!box) return std::nullopt;
  const int longer = std::max(box->width, box->height);
  const int side = longer + (longer * kMarginPercent + 50) / 100;
  return CropSquare{2 * box->x + box->width - side, 2 * box->y + box->height - side, side};
}

// Sums are whole and below 2^53; one multiplication and one addition round alike everywhere.
HandCrop crop_hand(const GrayImage& gray, const Mask& mask, const CropSquare& square) {
  GRASPDB_CHECK(gray.width() == mask.width() && gray.height() == mask.height());
  GRASPDB_CHECK(std::max(gray.width(), gray.height()) <= kLongestSide && square.side > 0);
  const PlaneSums sums = sum_square(gray, mask, square);
  const double area = 4.0 * square.side * square.side;
  const double bright = total(sums.gray);
  const double brightness =
      bright > 0 ? kCropGray * total(sums.mask) / bright / area : 0;  // of a black hand none
  return {scaled(sums.gray, brightness), scaled(sums.mask, 255 / area),
          scaled(sums.scene, brightness)};
}

}  // namespace graspdb
