// SPDX-License-Identifier: MIT
#include "rows.h"

#include <algorithm>

#include "graspdb/posed_scene.h"

namespace graspdb {
namespace {

Label make_label(const Eigen::Matrix3d& camera_from_hand, const JointAngles& angles) {
  Label label;
  const Eigen::Vector3f rotation = vector_from_rotation(camera_from_hand).cast<float>();
  std::copy_n(rotation.data(), 3, label.begin());
  for (int i = 0; i < kAngleCount; ++i) {
    label[static_cast<std::size_t>(i) + 3] = static_cast<float>(angles[i]);
  }
  return label;
}

// The box in tangents: what a camera at one metre would see in metres, from the palm centre's ray.
BoxTangents box_in_tangents(const Box& box, const Intrinsics& camera) {
  return {static_cast<float>((box.x - 0.5 - camera.cx) / camera.fx),
          static_cast<float>((box.y - 0.5 - camera.cy) / camera.fy),
          static_cast<float>(box.width / camera.fx), static_cast<float>(box.height / camera.fy)};
}

Row make_row(const Plan& plan, const PosedScene& posed, std::size_t view) {
  const Camera camera = crop_camera(plan.views[view], posed.centre, plan.config.distance,
                                    posed.hand_vertices, plan.config.resolution);
  const View picture = render(posed.scene, camera, plan.config.light);
  const Mask hand = visible_hand(picture);
  Row row;
  row.view = static_cast<std::uint32_t>(view);
  row.hog = describe(picture.shading, hand, plan.config.hog);
  if (const auto box = tight_box(hand)) row.box = box_in_tangents(*box, camera.intrinsics);
  return row;
}

}  // namespace

void make_rows(const Plan& plan, const Shard& shard, int step, std::span<Row> rows) {
  const Grasp grasp = fitted_to(plan.hands[shard.hand], plan.grasps[shard.grasp]);
  const GraspPose pose =
      pose_at_step(grasp, plan.rest, plan.closed[shard.hand][shard.grasp], step, plan.config.steps);
  const Solid* object = plan.variant_holds[shard.variant] ? grasp.object.get() : nullptr;
  const PosedScene posed = pose_scene(plan.hands[shard.hand], pose, object);
  for (std::size_t view = 0; view < rows.size(); ++view) {
    Row& row = rows[view] = make_row(plan, posed, view);
    row.label = make_label(plan.views[view], pose.angles);
    row.grasp = static_cast<std::uint16_t>(grasp.id);
    row.step = static_cast<std::uint8_t>(step);
  }
}

}  // namespace graspdb
