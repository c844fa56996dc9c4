// SPDX-License-Identifier: MIT
#include "frame_parts.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "graspdb/core/opencv/opencv_image.h"
#include "graspdb/features/hog.h"
#include "regions.h"

namespace graspdb {
namespace {

// Grown by a cell on all sides: pieces that are two cells apart touch.
Mask cells_of(const FrameParts& parts, std::initializer_list<PartCells FrameParts::*> shown) {
  Mask cells(parts.hand.width(), parts.hand.height());
  for (const auto part : shown) {
    std::ranges::transform(parts.*part, cells, cells.begin(),
                           [](std::uint8_t like, std::uint8_t is) {
                             return like >= kLikeAnyOther ? std::uint8_t{255} : is;
                           });
  }
  cv::Mat image = as_mat(cells);
  cv::dilate(image, image, cv::Mat());
  return cells;
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

struct HandCells {
  int in_roi = 0, all = 0;
};

HandCells count_hand(const FrameParts& parts, const Mask& region, const Box& roi) {
  HandCells cells;
  for (int y = 0; y < region.height(); ++y) {
    for (int x = 0; x < region.width(); ++x) {
      if (region.at(x, y) == 0 || parts.hand.at(x, y) < kLikeAnyOther) continue;
      ++cells.all;
      cells.in_roi += is_in(roi, x, y);
    }
  }
  return cells;
}

void clear_outside(const Mask& region, PartCells& cells) {
  std::ranges::transform(cells, region, cells.begin(), [](std::uint8_t like, std::uint8_t is) {
    return is != 0 ? like : std::uint8_t{0};
  });
}

Mask painted_region(const Regions& regions, std::size_t region, const Mask& like) {
  Mask mask(like.width(), like.height());
  regions.paint(region, mask);
  return mask;
}

}  // namespace

std::optional<FrameParts> largest_hand(const FrameParts& parts, int min_cells,
                                       const std::optional<Box>& roi) {
  const Mask held = cells_of(parts, {&FrameParts::hand, &FrameParts::object});
  const Box wanted = cells_in(roi.value_or(parts.window), parts);
  const Regions regions(held);
  std::optional<Mask> best;
  int most = 0;
  for (std::size_t i = 0; i < regions.all().size(); ++i) {
    Mask region = painted_region(regions, i, held);
    const HandCells cells = count_hand(parts, region, wanted);
    if (cells.all < min_cells || cells.in_roi <= most) continue;
    most = cells.in_roi;
    best = std::move(region);
  }
  if (!best) return std::nullopt;
  FrameParts result = parts;
  clear_outside(*best, result.hand);
  clear_outside(*best, result.object);
  // The arm that touches it.
  const Regions arms(cells_of(parts, {&FrameParts::arm}));
  Mask touching(held.width(), held.height());
  for (std::size_t i = 0; i < arms.all().size(); ++i) {
    const Mask arm = painted_region(arms, i, held);
    if (std::ranges::equal(arm, *best, [](auto a, auto b) { return a == 0 || b == 0; })) continue;
    arms.paint(i, touching);
  }
  clear_outside(touching, result.arm);
  return result;
}

Box hand_box(const FrameParts& parts) {
  Mask cells(parts.hand.width(), parts.hand.height());
  std::ranges::transform(parts.hand, cells.begin(), [](std::uint8_t like) {
    return static_cast<std::uint8_t>(like >= kLikeAnyOther ? 255 : 0);
  });
  const Box box = tight_box(cells).value_or(Box{});
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
