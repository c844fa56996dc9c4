// SPDX-License-Identifier: MIT
// What single rows of a configuration show, before a ray is cast: exactly what a build with that
// configuration renders.
#pragma once

#include <cstddef>
#include <memory>

#include "graspdb/generator/build_config.h"
#include "graspdb/generator/posed_scene.h"
#include "graspdb/grasps/grasp.h"
#include "graspdb/hand/hand.h"

namespace graspdb {

// The pose of a row, by what it is: all rows that differ only in their view have one.
struct PoseKey {
  std::size_t hand = 0;     // ordinal in the configuration's hands
  std::size_t variant = 0;  // as the variant column of a database of this configuration
  int grasp = 0;            // id
  int step = 1;             // 1..steps
  auto operator<=>(const PoseKey&) const = default;
};

struct RowPose {
  GraspPose pose;
  PosedScene scene;
  bool held = true;  // is the object there
};

// What a row is described from: shading and label.
View row_view(const Scene& scene, const Camera& camera, const Light& light, RowRenderer renderer);

// All hands and grasps of a configuration, loaded and closed. Thread-safe.
class RowPoses {
 public:
  // A second for each grasp and hand without a committed closed pose: let `only` name no more
  // grasps than are wanted. `threads` as in parallel_for. Throws Error for bad input, and when the
  // configuration's hashes are not those of its files.
  explicit RowPoses(const BuildConfig& config, int threads = 0);
  ~RowPoses();
  RowPoses(RowPoses&&) noexcept;
  RowPoses& operator=(RowPoses&&) noexcept;

  const BuildConfig& config() const;
  const Hand& hand(std::size_t ordinal) const;  // with all of its forearm
  const Grasp& grasp(int id) const;             // one of the configuration's
  // Takes a second where jitter changes the object's size, the first time for a grasp.
  RowPose pose(const PoseKey& key) const;
  Camera camera(const RowPose& pose, std::size_t view) const;  // view < config().views
  Light light(const PoseKey& key, std::size_t view) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace graspdb
