// SPDX-License-Identifier: MIT
// A descriptor of outlines and strong inner edges: see HogMode::kSoftEdges.
#include <algorithm>
#include <array>
#include <cmath>

#include "edge_rows.h"
#include "hog_modes.h"

namespace graspdb {
namespace {

constexpr int kSide = kEdgeSide;
constexpr int kCellSide = kSide / kCells;
// An outline across a cell, side to side, counts about as much.
constexpr float kFullVotes = kCellSide;

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
  EdgeCanvas coverage{};
  EdgeCanvas gray{};
};

struct RowSums {
  std::array<float, kSide> coverage, gray;
};

RowSums sum_row(const std::uint8_t* gray, const std::uint8_t* inside,
                const std::array<Span, kSide>& spans, int length) {
  RowSums sums;
  const float whole = static_cast<float>(kSide) / static_cast<float>(length);
  for (std::size_t i = 0; i < kSide; ++i) {
    const Span& span = spans[i];
    const auto sample = [&](int x) { return inside[x] != 0 ? int{gray[x]} : 0; };
    int inner_gray = 0, inner_count = 0;
    for (int x = span.first + 1; x < span.last; ++x) {
      inner_gray += sample(x);
      inner_count += inside[x] != 0;
    }
    sums.gray[i] = span.first_share * static_cast<float>(sample(span.first)) +
                   span.last_share * static_cast<float>(sample(span.last)) +
                   whole * static_cast<float>(inner_gray);
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
        out.coverage[edge_index(x, i)] += share * sums.coverage[static_cast<std::size_t>(x)];
        out.gray[edge_index(x, i)] += share * sums.gray[static_cast<std::size_t>(x)];
      }
    }
  }
  return out;
}

// The hand's brightness relative to its mean; where there is no hand, that mean, so that the
// outline makes no edge here.
EdgeCanvas relative_brightness(const Resampled& picture) {
  float gray = 0, coverage = 0;
  for (std::size_t i = 0; i < picture.gray.size(); ++i) {
    gray += picture.gray[i];
    coverage += picture.coverage[i];
  }
  const float mean = std::max(gray / coverage, 1.0F);
  EdgeCanvas brightness;
  for (std::size_t i = 0; i < brightness.size(); ++i) {
    const float covered = picture.coverage[i];
    brightness[i] = covered > 0 ? picture.gray[i] / (covered * mean) : 1.0F;
  }
  return brightness;
}

// What a pixel gives to the two cells whose centres it lies between; beyond the outermost centres
// all goes to that cell.
struct Share {
  std::size_t cell;  // the first one
  float first, second;
};

std::array<Share, kEdgeSide> shares_between_cells() {
  std::array<Share, kEdgeSide> shares{};
  for (std::size_t i = 0; i < kEdgeSide; ++i) {
    const float position = (static_cast<float>(i) + 0.5F) / kCellSide - 0.5F;
    const float inside = std::clamp(position, 0.0F, static_cast<float>(kCells - 1));
    const std::size_t cell = std::min(static_cast<std::size_t>(inside), kCells - std::size_t{2});
    const float second = inside - static_cast<float>(cell);
    shares[i] = {cell, 1 - second, second};
  }
  return shares;
}

using RowVotes = std::array<float, std::size_t{kCells} * kBins>;  // of a row of cells

// Splits the weight between the two nearest directions and the two nearest cells.
void vote(float position, float weight, const Share& share, RowVotes& votes) {
  if (weight <= 0) return;
  const int bin = static_cast<int>(position);
  const float upper = weight * (position - static_cast<float>(bin)), lower = weight - upper;
  float* first = votes.data() + share.cell * kBins;
  float* second = first + kBins;
  first[bin % kBins] += lower * share.first;
  first[(bin + 1) % kBins] += upper * share.first;
  second[bin % kBins] += lower * share.second;
  second[(bin + 1) % kBins] += upper * share.second;
}

RowVotes votes_of_row(const EdgeRow& edges, const std::array<Share, kEdgeSide>& shares) {
  RowVotes votes{};
  for (std::size_t x = 0; x < kEdgeSide; ++x) {
    vote(edges.outline_bin[x], edges.outline_weight[x], shares[x], votes);
    vote(edges.inner_bin[x], edges.inner_weight[x], shares[x], votes);
  }
  return votes;
}

void add(const RowVotes& votes, float share, float* cells) {
  for (std::size_t i = 0; i < votes.size(); ++i) cells[i] += share * votes[i];
}

}  // namespace

Descriptor describe_soft_edges(const GrayImage& gray, const Mask& mask, const Box& box) {
  const Resampled picture = resample(gray, mask, box);
  const EdgeCanvas brightness = relative_brightness(picture);
  static const std::array<Share, kEdgeSide> shares = shares_between_cells();
  std::array<float, kDescriptorSize> votes{};
  EdgeRow edges;
  for (std::size_t y = 0; y < kEdgeSide; ++y) {
    find_edges(picture.coverage, brightness, y, edges);
    const RowVotes of_row = votes_of_row(edges, shares);
    float* cells = votes.data() + shares[y].cell * of_row.size();
    add(of_row, shares[y].first, cells);
    add(of_row, shares[y].second, cells + of_row.size());
  }
  Descriptor descriptor;
  for (std::size_t i = 0; i < votes.size(); ++i) {
    const float share = std::min(votes[i] / kFullVotes, 1.0F);
    // NOLINTNEXTLINE(bugprone-incorrect-roundings): never negative; databases hold these very bytes
    descriptor[i] = static_cast<std::uint8_t>(255 * std::sqrt(share) + 0.5F);
  }
  return descriptor;
}

}  // namespace graspdb
