// SPDX-License-Identifier: MIT
#include "silhouette.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "cells.h"
#include "graspdb/core/opencv/opencv_image.h"

namespace graspdb {
namespace {

constexpr int kBoxCells = 36;  // of kSide: along the longer side of the box, in the middle

// Costs, as shares of the seen cells, chosen on photoreal training frames with the hand found.
constexpr double kArmSeen = 0.6;      // of a seen cell that only the arm covers; 1 without either
constexpr double kNothingSeen = 0.2;  // of a covered cell where no hand is seen
constexpr double kMoved = 4;  // of a move by the box's longer side and of a size e times as large,
                              // squared

// Metres, of a hand of kLength.
constexpr double kLength = 0.19;
constexpr double kPalmRadius = 0.011, kThumbRadius = 0.0105, kFingerRadius = 0.0085,
                 kArmRadius = 0.026;
constexpr double kArmLength = 0.08;

struct Capsule {
  int from, to;  // keypoints
  double radius;
};
constexpr std::array<Capsule, 24> kCapsules = {
    {{0, 1, kPalmRadius},     {1, 2, kThumbRadius},    {2, 3, kThumbRadius},
     {3, 4, kThumbRadius},    {0, 5, kPalmRadius},     {5, 6, kFingerRadius},
     {6, 7, kFingerRadius},   {7, 8, kFingerRadius},   {0, 9, kPalmRadius},
     {9, 10, kFingerRadius},  {10, 11, kFingerRadius}, {11, 12, kFingerRadius},
     {0, 13, kPalmRadius},    {13, 14, kFingerRadius}, {14, 15, kFingerRadius},
     {15, 16, kFingerRadius}, {0, 17, kPalmRadius},    {17, 18, kFingerRadius},
     {18, 19, kFingerRadius}, {19, 20, kFingerRadius}, {1, 5, kPalmRadius},
     {5, 9, kPalmRadius},     {9, 13, kPalmRadius},    {13, 17, kPalmRadius}}};
constexpr int kWrist = 0, kMiddleMcp = 9;
constexpr std::array kPalmOutline = {0, 1, 5, 9, 13, 17};

using Points = Eigen::Matrix<double, 2, kKeypointCount>;  // a column a keypoint

Cells packed(const cv::Mat& image) {
  Cells cells{};
  for (int y = 0; y < kSide; ++y) {
    const std::uint8_t* row = image.ptr(y);
    for (int x = 0; x < kSide; ++x) cells[y] |= std::uint64_t{row[x] > 127} << x;
  }
  return cells;
}

int count(const Cells& cells) {
  int total = 0;
  for (const std::uint64_t row : cells) total += std::popcount(row);
  return total;
}

class Drawing {
 public:
  // `cells_per_m`: a metre at the hand.
  explicit Drawing(double cells_per_m) : cells_per_m_(cells_per_m) {}

  void capsule(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double radius) {
    const double width = std::clamp(2 * radius * cells_per_m_, 1.0, double{kSide});
    const int thickness = static_cast<int>(std::lround(width));
    cv::line(image_, fixed(from), fixed(to), 255, thickness, cv::LINE_8, kFraction);
  }

  void hull(const Points& joints) {
    std::vector<cv::Point> corners, hull;
    for (const int joint : kPalmOutline) corners.push_back(fixed(joints.col(joint)));
    cv::convexHull(corners, hull);
    cv::fillConvexPoly(image_, hull, 255, cv::LINE_8, kFraction);
  }

  Cells cells() const { return packed(image_); }

 private:
  static constexpr int kFraction = 4;  // bits

  static cv::Point fixed(const Eigen::Vector2d& cell) {
    const Eigen::Vector2d near = cell.cwiseMax(-10 * kSide).cwiseMin(10 * kSide) * (1 << kFraction);
    return {static_cast<int>(std::lround(near.x())), static_cast<int>(std::lround(near.y()))};
  }

  double cells_per_m_;
  cv::Mat image_ = cv::Mat::zeros(kSide, kSide, CV_8U);
};

Cells drawn_hand(const Points& joints, double cells_per_m) {
  Drawing drawing(cells_per_m);
  drawing.hull(joints);
  for (const Capsule& capsule : kCapsules)
    drawing.capsule(joints.col(capsule.from), joints.col(capsule.to), capsule.radius);
  return drawing.cells();
}

Cells drawn_arm(const Points& joints, double cells_per_m) {
  Drawing drawing(cells_per_m);
  const Eigen::Vector2d wrist = joints.col(kWrist);
  const Eigen::Vector2d back = (wrist - joints.col(kMiddleMcp)).normalized();
  drawing.capsule(wrist, wrist + back * kArmLength * cells_per_m, kArmRadius);
  return drawing.cells();
}

// Where cells are in the picture.
struct Grid {
  Eigen::Vector2d first_px;  // the middle of the upper left cell
  double cell_px;

  explicit Grid(const Box& box)
      : cell_px(static_cast<double>(std::max(box.width, box.height)) / kBoxCells) {
    const Eigen::Vector2d middle(box.x + 0.5 * (box.width - 1), box.y + 0.5 * (box.height - 1));
    first_px = middle.array() - 0.5 * (kSide - 1) * cell_px;
  }

  // Those that the mask, whose box it is, covers by half.
  Cells covered_by(const Mask& mask, const Box& box) const {
    const int size = std::max(1, static_cast<int>(std::lround(cell_px)));
    cv::Mat averages, cells;
    cv::blur(as_mat(mask)(cv::Rect(box.x, box.y, box.width, box.height)), averages, {size, size},
             {-1, -1}, cv::BORDER_CONSTANT | cv::BORDER_ISOLATED);
    cv::Mat_<double> box_from_cells(2, 3);
    box_from_cells << cell_px, 0, first_px.x() - box.x, 0, cell_px, first_px.y() - box.y;
    cv::warpAffine(averages, cells, box_from_cells, {kSide, kSide},
                   cv::INTER_LINEAR | cv::WARP_INVERSE_MAP);
    return packed(cells);
  }

  Cells within(const Mask& picture) const {
    const auto is_within = [&](int cell, double first, int length) {
      const double px = first + cell * cell_px;
      return px > -0.5 && px < length - 0.5;
    };
    std::uint64_t columns = 0;
    for (int x = 0; x < kSide; ++x)
      columns |= std::uint64_t{is_within(x, first_px.x(), picture.width())} << x;
    Cells cells{};
    for (int y = 0; y < kSide; ++y)
      cells[y] = is_within(y, first_px.y(), picture.height()) ? columns : 0;
    return cells;
  }
};

struct Move {  // cells, about the middle of the keypoints
  int right = 0, down = 0;
  double scale = 1;
  double cost = std::numeric_limits<double>::infinity();
};

// What is seen, and what lies over it.
class Overlay {
 public:
  Overlay(const Mask& mask, const Box& box, const Grid& grid)
      : seen_(grid.covered_by(mask, box)), inside_(grid.within(mask)), seen_count_(count(seen_)) {}

  bool is_empty() const { return seen_count_ == 0; }

  void draw(const Points& joints, double cells_per_m) {
    hand_ = MovableCells(drawn_hand(joints, cells_per_m));
    arm_ = MovableCells(drawn_arm(joints, cells_per_m));
  }

  double cost(int right, int down) const {
    const Overlap cells = overlap_of(seen_, inside_, hand_, arm_, right, down);
    const double moved = std::hypot(right, down) / kBoxCells;
    return (cells.bare + kArmSeen * cells.of_arm + kNothingSeen * cells.in_vain) / seen_count_ +
           kMoved * moved * moved;
  }

  // A coarse look everywhere, then a fine one around the best.
  Move best_move(double reach) const {
    constexpr int kStep = 3;
    const int furthest = static_cast<int>(reach * kBoxCells);
    const Move coarse = best_around({}, furthest, furthest / kStep * kStep, kStep);
    return best_around(coarse, furthest, kStep - 1, 1);
  }

 private:
  // No further than `furthest` from where it was.
  Move best_around(const Move& middle, int furthest, int reach, int step) const {
    Move best;
    for (int down = middle.down - reach; down <= middle.down + reach; down += step) {
      for (int right = middle.right - reach; right <= middle.right + reach; right += step) {
        if (std::max(std::abs(right), std::abs(down)) > furthest) continue;
        const double here = cost(right, down);
        if (here < best.cost) best = {right, down, 1, here};
      }
    }
    return best;
  }

  Cells seen_, inside_;  // the latter: the picture
  int seen_count_;
  MovableCells hand_, arm_;
};

Move best_move(const Points& cells, double cells_per_m, double reach, Overlay& overlay) {
  constexpr std::array kScales = {1.0, 0.92, 1.08, 0.85, 1.17};
  const Eigen::Vector2d middle = cells.rowwise().mean();
  Move best;
  for (const double scale : kScales) {
    overlay.draw((scale * (cells.colwise() - middle)).colwise() + middle, scale * cells_per_m);
    Move move = overlay.best_move(reach);
    move.scale = scale;
    move.cost += kMoved * std::log(scale) * std::log(scale);
    if (move.cost < best.cost) best = move;
  }
  return best;
}

// False of what is no number, too.
bool is_before_camera(const PosedHand& hand, const Eigen::Vector3d& palm_center) {
  return hand.from_palm.row(2).minCoeff() + palm_center.z() > kNearestDepth &&
         palm_center.allFinite();
}

}  // namespace

Eigen::Vector3d laid_over(const Mask& mask, const Box& box, const Intrinsics& camera,
                          const PosedHand& hand, const Eigen::Vector3d& palm_center, double reach) {
  if (!is_before_camera(hand, palm_center)) return palm_center;
  const Keypoints joints = hand.from_palm.colwise() + palm_center;
  const Grid grid(box);
  const auto cell_of = [&](const Eigen::Vector3d& point) -> Eigen::Vector2d {
    return (camera.project(point) - grid.first_px) / grid.cell_px;
  };
  Points cells;
  for (int i = 0; i < kKeypointCount; ++i) cells.col(i) = cell_of(joints.col(i));
  const double px_per_m = camera.fx / palm_center.z() * hand.length / kLength;
  Overlay overlay(mask, box, grid);
  if (overlay.is_empty()) return palm_center;
  const Move move = best_move(cells, px_per_m / grid.cell_px, reach, overlay);

  const Eigen::Vector2d middle = cells.rowwise().mean(), shift(move.right, move.down);
  const Eigen::Vector2d palm = middle + move.scale * (cell_of(palm_center) - middle) + shift;
  const Eigen::Vector2d px = grid.first_px + palm * grid.cell_px;
  const Eigen::Vector3d moved = camera.ray(px.x(), px.y()) * (palm_center.z() / move.scale);
  return is_before_camera(hand, moved) ? moved : palm_center;
}

}  // namespace graspdb
