// SPDX-License-Identifier: MIT
#include "graspdb/pictures/estimate_picture.h"

#include <array>

#include "graspdb/hand/label.h"
#include "model_view.h"

namespace graspdb {
namespace {

constexpr std::uint8_t kDark = 24;

}  // namespace

const DatabaseRows& EstimatePicture::rows_like(std::uint32_t row) {
  const int grasp = database_.grasp(row);
  const auto known = rows_.find(grasp);
  if (known != rows_.end()) return known->second;
  const std::array<std::size_t, 1> one = {row};
  return rows_.emplace(grasp, DatabaseRows(database_, one)).first->second;
}

// Mirroring x turns a left hand into the right one that the tracker saw.
Eigen::Matrix3d EstimatePicture::right_hand_rotation(const Estimate& estimate) {
  const Eigen::Matrix3d& rotation = estimate.camera_from_hand.rotation;
  if (!estimate.left_hand) return rotation;
  const Eigen::DiagonalMatrix<double, 3> mirror(-1, 1, 1);
  return mirror * rotation * mirror;
}

ColorImage EstimatePicture::draw_turned(std::uint32_t row,
                                        const Eigen::Matrix3d& right_hand_rotation, bool left_hand,
                                        int side) {
  const RowPose pose = rows_like(row).pose(row);
  const PosedScene& posed = pose.scene;
  const Camera camera = crop_camera(right_hand_rotation, posed.center,
                                    database_.info().camera_distance, posed.hand_vertices, side);
  const ColorImage picture = colored(render(posed.scene, camera), {}, kDark);
  return left_hand ? mirrored(picture) : picture;
}

ColorImage EstimatePicture::draw(const Estimate& estimate, int side) {
  return draw_turned(estimate.row, right_hand_rotation(estimate), estimate.left_hand, side);
}

ColorImage EstimatePicture::draw_row(std::uint32_t row, bool left_hand, int side) {
  return draw_turned(row, unpack_label(database_.label(row)).rotation, left_hand, side);
}

}  // namespace graspdb
