// SPDX-License-Identifier: MIT
#include "frame_parts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "graspdb/core/opencv/opencv_image.h"
#include "graspdb/features/hog.h"
#include "graspdb/features/segmentation.h"
#include "regions.h"

namespace graspdb {
namespace {

void add(const Mask& more, Mask& mask) {
  std::ranges::transform(more, mask, mask.begin(), [](auto a, auto b) { return std::max(a, b); });
}

Mask painted_region(const Regions& regions, std::size_t region, const Mask& like) {
  Mask mask(like.width(), like.height());
  regions.paint(region, mask);
  return mask;
}

Box cells_in(const Box& roi, const FrameParts& parts) {
  const auto cell = [&](int pixel) {
    return static_cast<int>(std::floor(static_cast<double>(pixel) / parts.cell_px));
  };
  const int x = cell(roi.x - parts.window.x), y = cell(roi.y - parts.window.y);
  return {x, y, cell(roi.x + roi.width - 1 - parts.window.x) - x + 1,
          cell(roi.y + roi.height - 1 - parts.window.y) - y + 1};
}

bool is_in(const Box& box, int x, int y) {
  return x >= box.x && y >= box.y && x < box.x + box.width && y < box.y + box.height;
}

// Cells of hand and held object that are connected.
struct Piece {
  Mask cells, arms;  // grown by a cell; of the arms that touch it
  Box box;           // of its cells
  int hand = 0, hand_in_roi = 0;
};

void clear_outside(const Mask& region, PartCells& cells) {
  std::ranges::transform(cells, region, cells.begin(), [](std::uint8_t like, std::uint8_t is) {
    return is != 0 ? like : std::uint8_t{0};
  });
}

void count_hand(const FrameParts& parts, const Box& roi, Piece& piece) {
  for (int y = 0; y < piece.cells.height(); ++y) {
    for (int x = 0; x < piece.cells.width(); ++x) {
      if (piece.cells.at(x, y) == 0 || parts.hand.at(x, y) < kLikeAnyOther) continue;
      ++piece.hand;
      piece.hand_in_roi += is_in(roi, x, y);
    }
  }
}

// Those with some hand, the one with the most of it in `roi` first.
std::vector<Piece> pieces_of(const FrameParts& parts, const Box& roi) {
  const Mask held = grown(cells_of(parts, {&FrameParts::hand, &FrameParts::object}));
  const Regions regions(held), arms(grown(cells_of(parts, {&FrameParts::arm})));
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < regions.all().size(); ++i) {
    Piece piece{painted_region(regions, i, held), {}, regions.all()[i].box};
    count_hand(parts, roi, piece);
    if (piece.hand == 0) continue;
    piece.arms = arms_of(piece.cells, arms);
    pieces.push_back(std::move(piece));
  }
  std::ranges::stable_sort(pieces, std::greater(), &Piece::hand_in_roi);
  return pieces;
}

// An object that is not known for one cuts pieces off, too. They are no further away than a hand is
// long, of which its first piece may show but half; and no hand has two arms.
constexpr double kFurthestPiece = 2;  // in square roots of the first piece's cells

bool have_two_arms(const Piece& a, const Piece& b) {
  return !is_empty(a.arms) && !is_empty(b.arms) && !touch(a.arms, b.arms);
}

void join(const Piece& piece, Piece& hand) {
  add(piece.cells, hand.cells);
  add(piece.arms, hand.arms);
  hand.hand += piece.hand;
}

}  // namespace

Mask cells_of(const FrameParts& parts, std::initializer_list<PartCells FrameParts::*> shown) {
  Mask cells(parts.hand.width(), parts.hand.height());
  for (const auto part : shown) {
    std::ranges::transform(parts.*part, cells, cells.begin(),
                           [](std::uint8_t like, std::uint8_t is) {
                             return like >= kLikeAnyOther ? std::uint8_t{255} : is;
                           });
  }
  return cells;
}

bool touch(const Mask& a, const Mask& b) {
  return !std::ranges::equal(a, b, [](auto in_a, auto in_b) { return in_a == 0 || in_b == 0; });
}

Mask grown(Mask cells) {
  cv::Mat image = as_mat(cells);
  cv::dilate(image, image, cv::Mat());
  return cells;
}

Mask arms_of(const Mask& piece, const Regions& arms, int min_cells) {
  Mask touching(piece.width(), piece.height());
  for (std::size_t i = 0; i < arms.all().size(); ++i) {
    if (arms.all()[i].area_px < min_cells) continue;
    const Mask arm = painted_region(arms, i, piece);
    if (touch(arm, piece)) add(arm, touching);
  }
  return touching;
}

std::optional<FrameParts> largest_hand(const FrameParts& parts, int min_cells,
                                       const std::optional<Box>& roi) {
  std::vector<Piece> pieces = pieces_of(parts, cells_in(roi.value_or(parts.window), parts));
  if (pieces.empty() || pieces.front().hand_in_roi == 0) return std::nullopt;
  Piece& hand = pieces.front();
  const double furthest = kFurthestPiece * std::sqrt(hand.hand);
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const bool is_near = gap_between(pieces[i].box, hand.box) <= furthest;
    if (is_near && !have_two_arms(pieces[i], hand)) join(pieces[i], hand);
  }
  if (hand.hand < min_cells) return std::nullopt;
  FrameParts result = parts;
  clear_outside(hand.cells, result.hand);
  clear_outside(hand.cells, result.object);
  clear_outside(hand.arms, result.arm);
  return result;
}

Box hand_box(const FrameParts& parts) {
  const Box box = tight_box(cells_of(parts, {&FrameParts::hand})).value_or(Box{});
  return {parts.window.x + box.x * parts.cell_px, parts.window.y + box.y * parts.cell_px,
          box.width * parts.cell_px, box.height * parts.cell_px};
}

Mask painted(const PartCells& cells, const FrameParts& parts, int width, int height) {
  Mask mask(width, height);
  cv::Mat fine;
  cv::resize(as_mat(cells), fine, {}, parts.cell_px, parts.cell_px, cv::INTER_LINEAR_EXACT);
  cv::threshold(fine, fine, kLikeAnyOther - 1, 255, cv::THRESH_BINARY);
  const Box& window = parts.window;
  const cv::Size size(std::min(window.width, fine.cols), std::min(window.height, fine.rows));
  cv::Mat image = as_mat(mask);
  fine(cv::Rect({0, 0}, size)).copyTo(image(cv::Rect({window.x, window.y}, size)));
  return mask;
}

}  // namespace graspdb
