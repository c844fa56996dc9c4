// SPDX-License-Identifier: MIT
#include "graspdb/features/crop.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "graspdb/core/error.h"
#include "graspdb/features/hog.h"

namespace graspdb {
namespace {

constexpr int kMarginPercent = 8;  // of the side, half of it at either end
constexpr int kLongestSide = 1 << 14;

// How much a hand's contrast is changed: in flat light there is more noise than shading.
constexpr double kLeastContrast = 0.5, kMostContrast = 3;

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

using CropSums = std::array<std::uint64_t, kCropPixels>;
struct PlaneSums {
  CropSums gray{}, mask{}, scene{};
};

// One of the crop's rows while its columns are still the picture's: sums down the picture. They run
// along memory, many at a time, where sums across it do not.
class ColumnSums {
 public:
  explicit ColumnSums(int width) : gray_(at(width)), mask_(at(width)), scene_(at(width)) {}

  void clear() {
    for (Sums* sums : {&gray_, &mask_, &scene_}) std::ranges::fill(*sums, 0);
  }

  // The pixels from `first` on, as many as there are sums.
  void add(const std::uint8_t* gray, const std::uint8_t* mask, std::uint32_t share) {
    for (std::size_t x = 0; x < gray_.size(); ++x) {
      const std::uint32_t all = share * gray[x], inside = mask[x] != 0 ? ~0U : 0U;
      scene_[x] += all;
      gray_[x] += all & inside;
      mask_[x] += share & inside;
    }
  }

  void put(const CropSpans& columns, int first, std::size_t row, PlaneSums& planes) const {
    for (std::size_t i = 0; i < kCropSide; ++i) {
      const std::size_t to = row * kCropSide + i;
      planes.gray[to] = across(gray_, columns[i], first);
      planes.mask[to] = across(mask_, columns[i], first);
      planes.scene[to] = across(scene_, columns[i], first);
    }
  }

 private:
  using Sums = std::vector<std::uint32_t>;
  static std::size_t at(int x) { return static_cast<std::size_t>(x); }

  static std::uint64_t across(const Sums& sums, const CropSpan& span, int first) {
    if (span.last < span.first) return 0;
    std::uint64_t inner = 0;
    for (int x = span.first + 1; x < span.last; ++x) inner += sums[at(x - first)];
    const std::uint64_t ends = std::uint64_t{span.first_share} * sums[at(span.first - first)] +
                               std::uint64_t{span.last_share} * sums[at(span.last - first)];
    return inner * kUnit + ends;
  }

  Sums gray_, mask_, scene_;
};

// The picture's first column under the crop, and the one behind the last.
std::pair<int, int> columns_under(const CropSpans& spans) {
  int begin = kLongestSide, end = 0;
  for (const CropSpan& span : spans) {
    if (span.last < span.first) continue;
    begin = std::min(begin, span.first);
    end = std::max(end, span.last + 1);
  }
  return {begin, std::max(begin, end)};
}

PlaneSums sum_square(const GrayImage& gray, const Mask& mask, const CropSquare& square) {
  const CropSpans columns = crop_spans(square.left_x2, square.side, gray.width());
  const CropSpans rows = crop_spans(square.top_x2, square.side, gray.height());
  const auto [first, end] = columns_under(columns);
  ColumnSums sums(end - first);
  PlaneSums planes;
  for (std::size_t i = 0; i < kCropSide; ++i) {
    const CropSpan& span = rows[i];
    sums.clear();
    for (int y = span.first; y <= span.last; ++y) {
      const bool is_end = y == span.first || y == span.last;
      const std::uint32_t end_share = y == span.first ? span.first_share : span.last_share;
      sums.add(gray.row(y) + first, mask.row(y) + first, is_end ? end_share : kUnit);
    }
    sums.put(columns, first, i, planes);
  }
  return planes;
}

// A crop's pixel is gain * sum of greys + offset * sum of shares, of what lies under it.
struct Levels {
  double gain = 0, offset = 0;
};

CropPlane leveled(const CropSums& sums, const CropSums& shares, const Levels& levels) {
  CropPlane plane;
  for (std::size_t i = 0; i < kCropPixels; ++i) {
    const double level =
        static_cast<double>(sums[i]) * levels.gain + static_cast<double>(shares[i]) * levels.offset;
    plane[i] = static_cast<std::uint8_t>(std::clamp(level + 0.5, 0.0, 255.0));
  }
  return plane;
}

double total(const CropSums& sums) {
  return static_cast<double>(std::accumulate(sums.begin(), sums.end(), std::uint64_t{0}));
}

// Of the picture's grey levels, averaged under each of the crop's pixels, as the mask covers it.
struct Brightness {
  double mean = 0, deviation = 0;
};

Brightness brightness_of(const PlaneSums& sums) {
  const double covered = total(sums.mask);
  double squares = 0;
  for (std::size_t i = 0; i < kCropPixels; ++i) {
    if (sums.mask[i] == 0) continue;
    const auto gray = static_cast<double>(sums.gray[i]);
    squares += gray / static_cast<double>(sums.mask[i]) * gray;
  }
  const double mean = covered > 0 ? total(sums.gray) / covered : 0;
  return {mean, covered > 0 ? std::sqrt(std::max(squares / covered - mean * mean, 0.0)) : 0};
}

// `area` is the sum of shares under a pixel that the mask covers wholly.
Levels levels_of(const Brightness& hand, double area) {
  if (hand.mean <= 0) return {};  // a black hand stays black
  const double wanted = kCropContrast * hand.mean / kCropGray;
  const double contrast =
      std::clamp(wanted / std::max(hand.deviation, 1e-9), kLeastContrast, kMostContrast);
  return {kCropGray / hand.mean * contrast / area, kCropGray * (1 - contrast) / area};
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

// Sums are whole and below 2^53; the few steps after them, in this order, round alike everywhere.
HandCrop crop_hand(const GrayImage& gray, const Mask& mask, const CropSquare& square) {
  GRASPDB_CHECK(gray.width() == mask.width() && gray.height() == mask.height());
  GRASPDB_CHECK(std::max(gray.width(), gray.height()) <= kLongestSide && square.side > 0);
  const PlaneSums sums = sum_square(gray, mask, square);
  const double area = 4.0 * square.side * square.side;
  const Brightness hand = brightness_of(sums);
  const Levels scene{hand.mean > 0 ? kCropGray / hand.mean / area : 0};
  return {leveled(sums.gray, sums.mask, levels_of(hand, area)),
          leveled(sums.mask, sums.mask, {255 / area}), leveled(sums.scene, sums.mask, scene)};
}

}  // namespace graspdb
