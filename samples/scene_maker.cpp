// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "draw_rotation.h"
#include "graspdb/core/error.h"
#include "graspdb/core/transform.h"
#include "graspdb/generator/posed_scene.h"
#include "graspdb/samples/scenes.h"
#include "sample_hands.h"
#include "sample_poses.h"

namespace graspdb {
namespace {

constexpr int kMostCameras = 1000;  // that are drawn until one sees the hand
constexpr double kElbow = 0.26;     // metres from the wrist
constexpr double kNearestElbow = 0.15;

// Samples count their streams from 0 up, scenes from the other end down.
enum ScenePurpose : std::uint64_t {
  kHandOfScene,
  kPoseOfScene,
  kCamerasOfScene,
  kPurposesOfScenes
};

RandomStream scene_stream(const SampleConfig& config, ScenePurpose purpose, std::uint64_t number) {
  return RandomStream(static_cast<std::uint64_t>(config.seed),
                      ~(number * kPurposesOfScenes + purpose));
}

Eigen::Vector3d normal_vector(double deviation, RandomStream& random) {
  const double x = random.normal(), y = random.normal(), z = random.normal();
  return deviation * Eigen::Vector3d(x, y, z);
}

Eigen::Matrix3d small_turn(double deviation_deg, RandomStream& random) {
  Eigen::Vector3d turn = normal_vector(radians(deviation_deg), random);
  if (turn.norm() > kPi) turn.setZero();
  return rotation_from_vector(turn);
}

Intrinsics draw_lens(const SceneOptions& options, RandomStream& random) {
  const double half_width = std::tan(radians(random.uniform(22, 40)));
  return guess_camera(options.width, options.height, options.width / 2.0 / half_width);
}

// A point of the picture's inner part, at a distance that is as often twice as far as twice as
// near.
Eigen::Vector3d draw_place(const SampleConfig& config, const Intrinsics& lens,
                           RandomStream& random) {
  const double u = random.uniform(0.15, 0.85) * lens.width;
  const double v = random.uniform(0.15, 0.85) * lens.height;
  const double far =
      std::exp(random.uniform(std::log(config.nearest_m), std::log(config.farthest_m)));
  return far * lens.ray(u, v).normalized();
}

struct PosedHand {
  Keypoints joints;          // hand frame
  Eigen::Vector3d palm;      // hand frame
  Eigen::Vector3d to_elbow;  // hand frame, unit
};

PosedHand posed_hand(const Hand& hand, const GraspPose& pose) {
  const Skeleton& skeleton = hand.skeleton;
  return {keypoints_in_hand(skeleton, pose.angles), palm_center(skeleton, pose.angles),
          -hand_from_bones(skeleton, pose.angles)[kForearm].rotation.col(1)};
}

bool shows_hand(const PosedHand& hand, const Intrinsics& lens,
                const RigidTransform& camera_from_hand) {
  const Eigen::Vector3d elbow = camera_from_hand * (hand.to_elbow * kElbow);
  if (elbow.z() < kNearestElbow) return false;
  if (!inside_picture(lens, camera_from_hand * hand.palm)) return false;
  int inside = 0;
  for (const auto& joint : hand.joints.colwise())
    inside += inside_picture(lens, camera_from_hand * Eigen::Vector3d(joint));
  return 2 * inside >= kKeypointCount;
}

// A hand that turns and moves about a first view of it.
std::vector<RigidTransform> draw_motion(const PosedHand& hand, const Intrinsics& lens,
                                        const SampleConfig& config, int frames,
                                        RandomStream& random) {
  constexpr double kTurnDeg = 15,
                   kMove = 0.06;  // deviations; the second is a share of the distance
  const Eigen::Matrix3d first = draw_rotation(random);
  const Eigen::Vector3d place = draw_place(config, lens, random);
  std::vector<RigidTransform> motion;
  for (int i = 0; i < frames; ++i) {
    RigidTransform camera_from_hand;
    camera_from_hand.rotation = small_turn(kTurnDeg, random) * first;
    const Eigen::Vector3d palm = place + normal_vector(kMove * place.norm(), random);
    camera_from_hand.translation = palm - camera_from_hand.rotation * hand.palm;
    motion.push_back(camera_from_hand);
  }
  return motion;
}

std::vector<RigidTransform> visible_motion(const PosedHand& hand, const Intrinsics& lens,
                                           const SampleConfig& config, int frames,
                                           RandomStream& random) {
  for (int draw = 0; draw < kMostCameras; ++draw) {
    std::vector<RigidTransform> motion = draw_motion(hand, lens, config, frames, random);
    if (std::ranges::all_of(motion, [&](const RigidTransform& camera_from_hand) {
          return shows_hand(hand, lens, camera_from_hand);
        }))
      return motion;
  }
  throw Error("scenes: a hand that no camera sees");
}

}  // namespace

struct SceneMaker::State {
  SampleConfig config;
  SceneOptions options;
  HandLibrary library;
};

SceneMaker::SceneMaker(const SampleConfig& config, const SceneOptions& options, int threads)
    : state_(new State{config, options, load_hand_library(config, threads)}) {}
SceneMaker::~SceneMaker() = default;

MeshFrames SceneMaker::make(std::uint64_t number) const {
  const auto& [config, options, library] = *state_;
  const SampleHand shown = draw_hand(library, config, scene_stream(config, kHandOfScene, number));
  RandomStream poses = scene_stream(config, kPoseOfScene, number);
  const SamplePose drawn = draw_pose(library, shown, config, poses);
  RandomStream cameras = scene_stream(config, kCamerasOfScene, number);
  MeshFrames meshes{.name = fmt::format("scene-{:06}", number),
                    .camera = draw_lens(options, cameras),
                    .hand = with_visible_forearm(shown.hand, drawn.visible_forearm),
                    .visible_forearm = drawn.visible_forearm,
                    .object = drawn.object,
                    .skin_bgr = {125, 155, 215},
                    .object_bgr = {128, 128, 128},
                    .frames = {}};
  const PosedHand hand = posed_hand(meshes.hand, drawn.pose);
  const Eigen::Vector3d light = normal_vector(0.8, cameras) + Eigen::Vector3d(0, -0.5, -1);
  for (const RigidTransform& camera_from_hand :
       visible_motion(hand, meshes.camera, config, options.frames, cameras))
    meshes.frames.push_back({drawn.pose, camera_from_hand, light});
  return meshes;
}

}  // namespace graspdb
