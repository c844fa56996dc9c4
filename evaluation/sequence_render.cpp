// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graspdb/closing.h"
#include "graspdb/error.h"
#include "graspdb/posed_scene.h"
#include "graspdb/random.h"
#include "graspdb/renderer.h"
#include "graspdb/sequence.h"

namespace graspdb {
namespace {

// Fine enough that a step of the motion is far below a tenth of a degree.
constexpr int kClosureSteps = 10000;

Keyframe interpolate(const std::vector<Keyframe>& keys, double time) {
  const auto after = std::upper_bound(keys.begin(), keys.end(), time,
                                      [](double t, const Keyframe& key) { return t < key.time; });
  if (after == keys.begin()) return keys.front();
  if (after == keys.end()) return keys.back();
  const Keyframe& a = *(after - 1);
  const double share = (time - a.time) / (after->time - a.time);
  const auto blend = [share](const auto& from, const auto& to) {
    return from + (to - from) * share;
  };
  return {time, blend(a.closure, after->closure), a.view + (after->view - a.view) * share,
          a.palm + (after->palm - a.palm) * share};
}

// A wall lit from one side, neutral grey so that it is not taken for skin.
double background_level(int x, int y, const Intrinsics& camera) {
  return 95 + 60.0 * x / camera.width - 25.0 * y / camera.height;
}

Bgr shade(const Eigen::Vector3d& bgr, double level, double noise) {
  Bgr pixel;
  for (std::size_t c = 0; c < 3; ++c) {
    const double value = bgr[static_cast<int>(c)] * level + noise;
    pixel[c] = static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
  }
  return pixel;
}

ColorImage compose(const View& view, const SequenceSpec& spec, int frame) {
  ColorImage color(view.shading.width(), view.shading.height());
  RandomStream random(spec.seed, static_cast<std::uint64_t>(frame));
  for (int y = 0; y < color.height(); ++y) {
    for (int x = 0; x < color.width(); ++x) {
      const double noise = spec.sensor_noise * random.normal();
      const double level = view.shading.at(x, y) / 255.0;
      switch (view.label.at(x, y)) {
        case kHandSurface:
          color.at(x, y) = shade(spec.skin_bgr, level, noise);
          break;
        case kObjectSurface:
          color.at(x, y) = shade(spec.object_bgr, level, noise);
          break;
        default:
          color.at(x, y) =
              shade(Eigen::Vector3d::Ones(), background_level(x, y, spec.camera), noise);
      }
    }
  }
  return color;
}

Mask visible_object(const Image<std::uint8_t>& label) {
  Mask mask(label.width(), label.height());
  std::transform(label.begin(), label.end(), mask.begin(), [](std::uint8_t l) {
    return static_cast<std::uint8_t>(l == kObjectSurface ? 255 : 0);
  });
  return mask;
}

void refuse_collisions(const SequenceSpec& spec, const GraspPose& closed) {
  for (const StepCheck& step : check_grasp(spec.grasp, spec.hand, spec.rest, closed).steps) {
    if (step.penetration_mm <= 2) continue;
    throw Error(
        {spec.file.string(), "grasp", "an object that the hand does not enter by more than 2 mm",
         fmt::format("{:.1f} mm at {} of {} steps", step.penetration_mm, step.step, kStepCount)});
  }
}

}  // namespace

SequenceRenderer::SequenceRenderer(SequenceSpec spec)
    : spec_(std::move(spec)), closed_(close_grasp(spec_.grasp, spec_.hand)) {
  refuse_collisions(spec_, closed_);
  spec_.grasp = fitted_to(spec_.hand, std::move(spec_.grasp));
  spec_.hand = with_visible_forearm(spec_.hand, spec_.visible_forearm);
}

GraspPose SequenceRenderer::pose(double closure) const {
  const int step = static_cast<int>(std::lround(closure * kClosureSteps));
  return pose_at_step(spec_.grasp, spec_.rest, closed_, step, kClosureSteps);
}

FrameTruth SequenceRenderer::truth(int frame) const {
  const double time = spec_.keyframes.front().time + frame / spec_.frames_per_second;
  const Keyframe key = interpolate(spec_.keyframes, time);
  FrameTruth truth;
  truth.time = time;
  truth.closure = key.closure;
  truth.angles = pose(key.closure).angles;
  truth.camera_from_hand = camera_from_view(key.view);
  truth.wrist = key.palm - truth.camera_from_hand * palm_centre(spec_.hand.skeleton, truth.angles);
  truth.joints =
      (truth.camera_from_hand * keypoints_in_palm(spec_.hand.skeleton, truth.angles)).colwise() +
      truth.wrist;
  return truth;
}

SequenceFrame SequenceRenderer::render(int frame) const {
  SequenceFrame result;
  result.truth = truth(frame);
  const Solid* object = spec_.object_visible ? spec_.grasp.object.get() : nullptr;
  const PosedScene posed = pose_scene(spec_.hand, pose(result.truth.closure), object);
  const Camera camera{spec_.camera, {result.truth.camera_from_hand, result.truth.wrist}};
  const Light light{.towards_light_in_camera = spec_.towards_light};
  const View view = graspdb::render(posed.scene, camera, light);
  result.color = compose(view, spec_, frame);
  result.hand = visible_hand(view);
  result.object = visible_object(view.label);
  return result;
}

}  // namespace graspdb
