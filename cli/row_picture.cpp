// SPDX-License-Identifier: MIT
#include "row_picture.h"

#include <algorithm>

#include "console.h"
#include "graspdb/closing.h"
#include "graspdb/file.h"
#include "graspdb/posed_scene.h"
#include "graspdb/rig.h"

namespace graspdb::cli {
namespace {

constexpr double kShownForearm = 0.06;
const Bgr kObjectTint = {200, 140, 70};
const Bgr kSkinTint = {150, 180, 235};

ColorImage tint(const View& view) {
  ColorImage color(view.shading.width(), view.shading.height());
  for (std::size_t i = 0; i < color.size(); ++i) {
    const std::uint8_t label = view.label.data()[i];
    const Bgr& base = label == kObjectSurface ? kObjectTint : kSkinTint;
    for (std::size_t c = 0; c < 3; ++c) {
      const int shaded = label == kBackground ? 24 : base[c] * view.shading.data()[i] / 255;
      color.data()[i][c] = static_cast<std::uint8_t>(shaded);
    }
  }
  return color;
}

ColorImage mirrored(ColorImage picture) {
  for (int y = 0; y < picture.height(); ++y)
    std::reverse(picture.row(y), picture.row(y) + picture.width());
  return picture;
}

}  // namespace

RowPicture::RowPicture(const Database& database, bool left_hand)
    : database_(database),
      left_hand_(left_hand),
      grasps_(load_grasps(grasp_directory())),
      rest_(load_rest_pose(grasp_directory())) {}

const Hand* RowPicture::hand_of(std::uint32_t row) {
  const std::string& name = database_.info().hands[database_.hand(row)].name;
  const auto [entry, is_new] = hands_.try_emplace(name);
  const auto file = data_directory() / "assets/hands" / (name + ".glb");
  if (is_new && std::filesystem::exists(file)) {
    entry->second = with_visible_forearm(load_hand(file), kShownForearm);
  }
  return entry->second ? &*entry->second : nullptr;
}

const Grasp* RowPicture::grasp_of(int id) const {
  const auto found =
      std::find_if(grasps_.begin(), grasps_.end(), [id](const Grasp& g) { return g.id == id; });
  return found == grasps_.end() ? nullptr : &*found;
}

const GraspPose& RowPicture::closed_of(const Grasp& grasp, const Hand& hand) {
  const auto [entry, is_new] = closed_.try_emplace({hand.name, grasp.id});
  if (is_new) entry->second = closed_pose(grasp, hand);
  return entry->second;
}

// Mirroring x turns a left hand into the right one that the tracker saw.
Eigen::Matrix3d RowPicture::right_hand_rotation(const Estimate& estimate) const {
  if (!left_hand_) return estimate.camera_from_hand;
  const Eigen::DiagonalMatrix<double, 3> mirror(-1, 1, 1);
  return mirror * estimate.camera_from_hand * mirror;
}

std::optional<ColorImage> RowPicture::draw(const Estimate& estimate, int side) {
  const Hand* hand = hand_of(estimate.row);
  const Grasp* grasp = grasp_of(estimate.grasp);
  if (hand == nullptr || grasp == nullptr) return std::nullopt;
  const GraspPose pose =
      pose_at_step(*grasp, rest_, closed_of(*grasp, *hand), estimate.step, database_.info().steps);
  const std::string& variant = database_.info().variants[database_.variant(estimate.row)];
  const bool held = variant.starts_with("held");
  const Grasp fitted = fitted_to(*hand, *grasp);
  const PosedScene posed = pose_scene(*hand, pose, held ? fitted.object.get() : nullptr);
  const Camera camera = crop_camera(right_hand_rotation(estimate), posed.centre,
                                    database_.info().camera_distance, posed.hand_vertices, side);
  const ColorImage picture = tint(render(posed.scene, camera));
  return left_hand_ ? mirrored(picture) : picture;
}

}  // namespace graspdb::cli
