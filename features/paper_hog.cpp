// SPDX-License-Identifier: MIT
// The descriptor of Romero et al. (ICRA 2010), in integers, so that it is the same everywhere.
#include <algorithm>
#include <array>
#include <cmath>

#include "hog_modes.h"

namespace graspdb {
namespace {

constexpr std::uint8_t kNoVote = kBins;

// The box with everything outside the mask set to 0 and a frame of zeros around it.
GrayImage masked_crop(const GrayImage& gray, const Mask& mask, const Box& box) {
  GrayImage crop(box.width + 2, box.height + 2);
  for (int y = 0; y < box.height; ++y) {
    const std::uint8_t* shade = gray.row(box.y + y) + box.x;
    const std::uint8_t* inside = mask.row(box.y + y) + box.x;
    std::uint8_t* out = crop.row(y + 1) + 1;
    for (int x = 0; x < box.width; ++x) {
      out[x] = inside[x] != 0 ? shade[x] : std::uint8_t{0};
    }
  }
  return crop;
}

// floor(angle / 22.5 degrees) of the gradient's direction, taken modulo 180; 0 where there is none.
// tan(22.5) = sqrt(2) - 1 and tan(67.5) = sqrt(2) + 1, so that squares of whole numbers (exact in
// float) tell on which side of a bin's edge a gradient lies. Without branches, for the vectoriser.
int orientation_bin(float gx, float gy) {
  const float across = std::abs(gx), down = std::abs(gy);
  const float twice = 2 * across * across;
  const float sum = across + down, difference = down - across;
  const int over_22 = sum * sum > twice;
  const int over_45 = difference > 0;
  const int over_67 = over_45 & static_cast<int>(difference * difference > twice);
  const int at_45 = static_cast<int>(difference == 0) & static_cast<int>(down > 0);
  const int from_90 =
      static_cast<int>(gx * gy < 0) | (static_cast<int>(across == 0) & static_cast<int>(down > 0));
  const int upper_edges = over_22 + over_45 + over_67;
  return from_90 ? 7 - upper_edges : upper_edges + at_45;
}

// One row of the box between its neighbours; each pointer is at the pixel left of the box.
struct Rows {
  const std::uint8_t* above;
  const std::uint8_t* here;
  const std::uint8_t* below;
};

void row_bins(const Rows& rows, int width, std::uint8_t* bins) {
  const auto [above, here, below] = rows;
  for (int x = 0; x < width; ++x) {
    const int left = above[x] + 2 * here[x] + below[x];
    const int right = above[x + 2] + 2 * here[x + 2] + below[x + 2];
    const int top = above[x] + 2 * above[x + 1] + above[x + 2];
    const int bottom = below[x] + 2 * below[x + 1] + below[x + 2];
    bins[x] = static_cast<std::uint8_t>(
        orientation_bin(static_cast<float>(right - left), static_cast<float>(bottom - top)));
  }
}

// Withdraws the votes of what is no hand and of places whose nine pixels are all alike.
void drop_votes(const Rows& rows, const std::uint8_t* inside, int width, std::uint8_t* bins) {
  const auto [above, here, below] = rows;
  for (int x = 0; x < width; ++x) {
    const std::uint8_t center = here[x + 1];
    const int upper = (above[x] ^ center) | (above[x + 1] ^ center) | (above[x + 2] ^ center);
    const int lower = (below[x] ^ center) | (below[x + 1] ^ center) | (below[x + 2] ^ center);
    const int varies = upper | lower | (here[x] ^ center) | (here[x + 2] ^ center);
    const bool votes = static_cast<int>(varies != 0) & static_cast<int>(inside[x] != 0);
    bins[x] = votes ? bins[x] : kNoVote;
  }
}

struct Cell {
  std::array<std::uint32_t, kBins + 1> votes{};  // the last counts pixels without a vote
  std::uint32_t hand_pixels = 0;
  std::uint32_t area = 0;
};

// Adds the pixels of one row of the box to the row of cells it crosses.
void add_row(const std::uint8_t* votes, const std::uint8_t* inside, int width,
             std::array<Cell, kCells>& cells) {
  for (int c = 0; c < kCells; ++c) {
    Cell& cell = cells[static_cast<std::size_t>(c)];
    const int start = c * (width / kCells);
    const int end = c + 1 < kCells ? start + width / kCells : width;
    for (int x = start; x < end; ++x) ++cell.votes[votes[x]];
    for (int x = start; x < end; ++x) cell.hand_pixels += inside[x] != 0;
    cell.area += static_cast<std::uint32_t>(end - start);
  }
}

// 255 * (share of the votes) * (share of hand pixels), rounded, halves up.
void write_cell(const Cell& cell, std::uint8_t* bins) {
  std::uint64_t total = 0;
  for (int b = 0; b < kBins; ++b) total += cell.votes[static_cast<std::size_t>(b)];
  if (total == 0) return;
  const std::uint64_t divisor = 2 * total * cell.area;
  for (int b = 0; b < kBins; ++b) {
    const std::uint64_t dividend =
        2ULL * 255 * cell.votes[static_cast<std::size_t>(b)] * cell.hand_pixels;
    bins[b] = static_cast<std::uint8_t>((dividend + divisor / 2) / divisor);
  }
}

}  // namespace

Descriptor describe_paper(const GrayImage& gray, const Mask& mask, const Box& box) {
  const GrayImage crop = masked_crop(gray, mask, box);
  std::vector<std::uint8_t> votes(static_cast<std::size_t>(box.width));
  Descriptor descriptor{};
  for (int c = 0; c < kCells; ++c) {
    std::array<Cell, kCells> cells;
    const int end = c + 1 < kCells ? (c + 1) * (box.height / kCells) : box.height;
    for (int y = c * (box.height / kCells); y < end; ++y) {
      const std::uint8_t* inside = mask.row(box.y + y) + box.x;
      const Rows rows{crop.row(y), crop.row(y + 1), crop.row(y + 2)};
      row_bins(rows, box.width, votes.data());
      drop_votes(rows, inside, box.width, votes.data());
      add_row(votes.data(), inside, box.width, cells);
    }
    for (int i = 0; i < kCells; ++i) {
      const std::ptrdiff_t cell = static_cast<std::ptrdiff_t>(c) * kCells + i;
      write_cell(cells[static_cast<std::size_t>(i)], descriptor.data() + cell * kBins);
    }
  }
  return descriptor;
}

}  // namespace graspdb
