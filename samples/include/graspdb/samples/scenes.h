// SPDX-License-Identifier: MIT
// Hands in front of a camera, for pictures that another renderer makes: drawn as those of training
// pictures are, each in a few frames of a short motion.
#pragma once

#include <cstdint>
#include <memory>

#include "graspdb/samples/sample_config.h"
#include "graspdb/sequences/meshes.h"

namespace graspdb {

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

  // The palm is in the picture, and half of the joints are, in every frame; the elbow is in
  // front of the camera.
  MeshFrames make(std::uint64_t number) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace graspdb
