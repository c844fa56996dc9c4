// SPDX-License-Identifier: MIT
#include "rows.h"

#include <algorithm>

#include "graspdb/features/embedding.h"
#include "graspdb/generator/posed_scene.h"
#include "jitter.h"

namespace graspdb {
namespace {

// The box in tangents: what a camera at one metre would see in metres, from the palm centre's ray.
BoxTangents box_in_tangents(const Box& box, const Intrinsics& camera) {
  return {static_cast<float>((box.x - 0.5 - camera.cx) / camera.fx),
          static_cast<float>((box.y - 0.5 - camera.cy) / camera.fy),
          static_cast<float>(box.width / camera.fx), static_cast<float>(box.height / camera.fy)};
}

JitterDraw draw_of(const Plan& plan, const Shard& shard) {
  return {plan.config.jitter, plan.hands[shard.hand].name, plan.grasps[shard.grasp].id,
          plan.variants[shard.variant].copy};
}

Row make_row(const Plan& plan, const JitterDraw& draw, const PosedScene& posed, std::size_t view) {
  const Camera camera = row_camera(plan, posed, view);
  const Light light = draw.light(plan.config.light, view);
  const View picture = row_view(posed.scene, camera, light, plan.config.renderer);
  const Mask hand = visible_hand(picture);
  Row row;
  row.view = static_cast<std::uint32_t>(view);
  row.hog = describe(picture.shading, hand, plan.config.hog);
  if (plan.net) {
    // A hand that its object hides wholly has no direction.
    const Embedding hidden(plan.net->size(), 128);
    row.embedding = plan.net->describe(picture.shading, hand).value_or(hidden);
  }
  if (const auto box = tight_box(hand)) row.box = box_in_tangents(*box, camera.intrinsics);
  return row;
}

}  // namespace

View row_view(const Scene& scene, const Camera& camera, const Light& light, RowRenderer renderer) {
  return renderer == RowRenderer::kRaster ? rasterize(scene, camera, light)
                                          : render(scene, camera, light);
}

SizedGrasp sized_grasp(const Plan& plan, const Shard& shard) {
  const Hand& hand = plan.hands[shard.hand];
  const Grasp grasp = fitted_to(hand, plan.grasps[shard.grasp]);
  if (plan.config.jitter.object_size_percent == 0) {
    return {grasp, plan.closed[shard.hand][shard.grasp]};
  }
  Grasp resized = grasp;
  resized.object = scaled(grasp.object, draw_of(plan, shard).object_scale());
  return {resized, close_grasp(resized, hand)};
}

const SizedGrasp& SizedGrasps::of(const Shard& shard) {
  const auto entry_of = [&]() -> Entry& {
    const std::lock_guard lock(mutex_);
    return known_[{shard.hand, shard.grasp, plan_.variants[shard.variant].copy}];
  };
  Entry& entry = entry_of();
  std::call_once(entry.made, [&] { entry.grasp = sized_grasp(plan_, shard); });
  return entry.grasp;
}

RowPose pose_rows(const Plan& plan, const Shard& shard, const SizedGrasp& sized, int step) {
  const JitterDraw draw = draw_of(plan, shard);
  GraspPose pose = pose_at_step(sized.grasp, plan.rest, sized.closed, step, plan.config.steps);
  pose.angles = draw.angles(pose.angles);
  const Hand hand = with_visible_forearm(plan.hands[shard.hand],
                                         draw.visible_forearm(plan.config.visible_forearm));
  const bool held = plan.variants[shard.variant].holds;
  return {pose, pose_scene(hand, pose, held ? sized.grasp.object.get() : nullptr), held};
}

Camera row_camera(const Plan& plan, const PosedScene& posed, std::size_t view) {
  return crop_camera(plan.views[view], posed.center, plan.config.distance, posed.hand_vertices,
                     plan.config.resolution);
}

Light row_light(const Plan& plan, const Shard& shard, std::size_t view) {
  return draw_of(plan, shard).light(plan.config.light, view);
}

void make_rows(const Plan& plan, const Shard& shard, const SizedGrasp& sized, int step,
               std::span<Row> rows, const std::function<void()>& heed) {
  const JitterDraw draw = draw_of(plan, shard);
  const RowPose posed = pose_rows(plan, shard, sized, step);
  for (std::size_t view = 0; view < rows.size(); ++view) {
    if (heed) heed();
    Row& row = rows[view] = make_row(plan, draw, posed.scene, view);
    row.label = pack_label({plan.views[view], posed.pose.angles});
    row.grasp = static_cast<std::uint16_t>(sized.grasp.id);
    row.step = static_cast<std::uint8_t>(step);
  }
}

}  // namespace graspdb
