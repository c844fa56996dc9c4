// SPDX-License-Identifier: MIT
// Hands in front of a camera, for pictures that another renderer makes: drawn as those of training
// pictures are, each in a few frames of a short motion, with what every pixel shows.
#pragma once

#include <cstdint>
#include <memory>

#include "graspdb/samples/sample_config.h"
#include "graspdb/sequences/meshes.h"

namespace graspdb {

// What a pixel of a scene shows.
enum SceneLabel : std::uint8_t {
  kSceneRest = 0,
  kSceneHand = 1,
  kSceneForearm = 2,  // skin beyond the wrist
  kSceneObject = 3,   // what the hand holds
};
// Where the hand ends: so much of the arm, from the wrist joint, is still labelled hand. Where rows
// and cut_forearm() end, too.
constexpr double kHandBeyondWrist = 0.015;  // metres

struct SceneOptions {
  int frames = 4;
  int width = 320, height = 240;  // pixels
};

// Draws scenes: each is a pure function of configuration, options and its number. Of the
// configuration what is said of hands, poses and distances holds; pictures and masks are others'
// work. Thread-safe.
class SceneMaker {
 public:
  // Throws Error for bad input. Closed poses that are not committed take a second each.
  SceneMaker(const SampleConfig& config, const SceneOptions& options, int threads = 0);
  ~SceneMaker();

  // The palm is in the picture, and half of the joints are, in every frame; the arm does not reach
  // behind the camera. Labels are SceneLabels.
  MeshFrames make(std::uint64_t number) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace graspdb
