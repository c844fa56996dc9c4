// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "graspdb/core/error.h"
#include "graspdb/core/random.h"
#include "graspdb/generator/posed_scene.h"
#include "graspdb/grasps/closing.h"
#include "graspdb/hand/turns.h"
#include "graspdb/renderer/renderer.h"
#include "graspdb/sequences/sequence.h"

namespace graspdb {
namespace {

// Fine enough that a step of the motion is far below a tenth of a degree.
constexpr int kClosureSteps = 10000;

constexpr double kLightSum = 0.95;  // of ambient and directed light, as in Light

Keyframe interpolate(const std::vector<Keyframe>& keys, double time) {
  const auto after = std::upper_bound(keys.begin(), keys.end(), time,
                                      [](double t, const Keyframe& key) { return t < key.time; });
  if (after == keys.begin()) return keys.front();
  if (after == keys.end()) return keys.back();
  const Keyframe& a = *(after - 1);
  const double share = (time - a.time) / (after->time - a.time);
  const auto blend = [share]<typename Value>(const Value& from, const Value& to) -> Value {
    return from + (to - from) * share;
  };
  return {.time = time,
          .closure = blend(a.closure, after->closure),
          .view = blend(a.view, after->view),
          .palm = blend(a.palm, after->palm),
          .wrist = blend(a.wrist, after->wrist),
          .towards_light = blend(a.towards_light, after->towards_light)};
}

// A wall lit from one side, neutral grey so that it is not taken for skin.
double background_level(int x, int y, const Intrinsics& camera) {
  return 95 + 60.0 * x / camera.width - 25.0 * y / camera.height;
}

std::uint8_t clipped(double value) {
  return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
}

Bgr shade(const Eigen::Vector3d& bgr, double level) {
  return {clipped(bgr[0] * level), clipped(bgr[1] * level), clipped(bgr[2] * level)};
}

ColorImage paint(const View& view, const SequenceSpec& spec) {
  ColorImage color(view.shading.width(), view.shading.height());
  for (int y = 0; y < color.height(); ++y) {
    for (int x = 0; x < color.width(); ++x) {
      const double level = view.shading.at(x, y) / 255.0;
      switch (view.label.at(x, y)) {
        case kHandSurface:
          color.at(x, y) = shade(spec.look.skin_bgr, level);
          break;
        case kObjectSurface:
          color.at(x, y) = shade(spec.look.object_bgr, level);
          break;
        default:
          color.at(x, y) = shade(Eigen::Vector3d::Ones(), background_level(x, y, spec.camera));
      }
    }
  }
  return color;
}

// What lens and sensor do to the picture.
ColorImage photographed(ColorImage color, const SequenceSpec& spec, int frame) {
  if (spec.look.blur_px > 0) {
    cv::Mat picture(color.height(), color.width(), CV_8UC3, color.data());
    cv::GaussianBlur(picture, picture, {}, spec.look.blur_px);
  }
  RandomStream random(spec.seed, static_cast<std::uint64_t>(frame));
  for (Bgr& pixel : color) {
    const double noise = spec.look.sensor_noise * random.normal();
    for (std::uint8_t& level : pixel) level = clipped(level + noise);
  }
  return color;
}

// Skin that is lighter and darker in patches of a centimetre or two: waves across the bind pose in
// random directions.
void mottle(Hand& hand, double amount, std::uint64_t seed) {
  constexpr int kWaves = 12;
  constexpr double kShortest = 0.008, kLongest = 0.03;  // metres
  RandomStream random(seed, 0x6d6f74746c65);            // no frame has this number
  std::vector<std::pair<Eigen::Vector3d, double>> waves;
  for (int i = 0; i < kWaves; ++i) {
    const Eigen::Vector3d direction(random.normal(), random.normal(), random.normal());
    const double length = random.uniform(kShortest, kLongest);
    waves.emplace_back(direction.normalized() * (2 * kPi / length), random.uniform(0, 2 * kPi));
  }
  Mesh& mesh = hand.bind_mesh;
  mesh.albedo.resize(mesh.vertices.size(), 1.0F);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    double sum = 0;
    for (const auto& [number, phase] : waves) {
      sum += std::sin(number.dot(mesh.vertices[v].cast<double>()) + phase);
    }
    mesh.albedo[v] *= static_cast<float>(1 + amount * sum / std::sqrt(kWaves / 2.0));
  }
}

double hidden_share(const View& view) {
  std::size_t hand = 0, hidden = 0;
  for (std::size_t i = 0; i < view.label.size(); ++i) {
    if (view.hand_amodal.data()[i] == 0) continue;
    ++hand;
    hidden += view.label.data()[i] == kObjectSurface;
  }
  return hand > 0 ? static_cast<double>(hidden) / static_cast<double>(hand) : 0;
}

Mask visible_object(const Image<std::uint8_t>& label) {
  Mask mask(label.width(), label.height());
  std::transform(label.begin(), label.end(), mask.begin(), [](std::uint8_t l) {
    return static_cast<std::uint8_t>(l == kObjectSurface ? 255 : 0);
  });
  return mask;
}

void refuse_collisions(const SequenceSpec& spec, const Hand& hand, const GraspPose& closed) {
  for (const StepCheck& step : check_grasp(spec.grasp, hand, spec.rest, closed).steps) {
    if (step.penetration_mm <= 2) continue;
    throw Error(
        {spec.file.string(), "grasp", "an object that the hand does not enter by more than 2 mm",
         fmt::format("{:.1f} mm at {} of {} steps", step.penetration_mm, step.step, kStepCount)});
  }
}

}  // namespace

SequenceRenderer::SequenceRenderer(SequenceSpec spec)
    : spec_(std::move(spec)),
      hand_(sequence_hand(spec_)),
      closed_(closed_pose(spec_.grasp, hand_)) {
  refuse_collisions(spec_, hand_, closed_);
  spec_.grasp = fitted_to(hand_, std::move(spec_.grasp));
  hand_ = with_visible_forearm(std::move(hand_), spec_.visible_forearm);
  if (spec_.look.skin_mottling > 0) mottle(hand_, spec_.look.skin_mottling, spec_.seed);
}

GraspPose SequenceRenderer::pose(const Keyframe& key) const {
  const int step = static_cast<int>(std::lround(key.closure * kClosureSteps));
  GraspPose pose = pose_at_step(spec_.grasp, spec_.rest, closed_, step, kClosureSteps);
  pose.angles[kWristFlexion] += key.wrist[0];
  pose.angles[kWristDeviation] += key.wrist[1];
  pose.angles = clamp_to_range(pose.angles);
  return pose;
}

Keyframe SequenceRenderer::key(int frame) const {
  return interpolate(spec_.keyframes,
                     spec_.keyframes.front().time + frame / spec_.frames_per_second);
}

FrameGeometry SequenceRenderer::geometry(const Keyframe& key) const {
  FrameGeometry geometry{.pose = pose(key), .towards_light = key.towards_light};
  geometry.camera_from_hand.rotation = rotation_from_turns(key.view);
  geometry.camera_from_hand.translation =
      key.palm -
      geometry.camera_from_hand.rotation * palm_center(hand_.skeleton, geometry.pose.angles);
  return geometry;
}

FrameTruth SequenceRenderer::truth(const Keyframe& key, const FrameGeometry& geometry) const {
  FrameTruth truth;
  truth.time = key.time;
  truth.closure = key.closure;
  truth.angles = geometry.pose.angles;
  truth.camera_from_hand = geometry.camera_from_hand;
  const auto& [rotation, wrist] = truth.camera_from_hand;
  truth.joints = (rotation * keypoints_in_hand(hand_.skeleton, truth.angles)).colwise() + wrist;
  return truth;
}

FrameGeometry SequenceRenderer::geometry(int frame) const {
  return geometry(key(frame));
}

FrameTruth SequenceRenderer::truth(int frame) const {
  const Keyframe now = key(frame);
  return truth(now, geometry(now));
}

SequenceFrame SequenceRenderer::render(int frame) const {
  SequenceFrame result;
  const Keyframe now = key(frame);
  const FrameGeometry geometry = this->geometry(now);
  result.truth = truth(now, geometry);
  const Solid* object = spec_.object_visible ? spec_.grasp.object.get() : nullptr;
  const PosedScene posed = pose_scene(hand_, geometry.pose, object);
  const Camera camera{spec_.camera, geometry.camera_from_hand};
  const Light light{.ambient = spec_.look.ambient,
                    .diffuse = kLightSum - spec_.look.ambient,
                    .towards_light_in_camera = geometry.towards_light};
  const View view = graspdb::render(posed.scene, camera, light, {.amodal = true});
  result.color = photographed(paint(view, spec_), spec_, frame);
  result.occlusion = hidden_share(view);
  result.hand = visible_hand(view);
  result.object = visible_object(view.label);
  return result;
}

}  // namespace graspdb
