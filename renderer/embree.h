// SPDX-License-Identifier: MIT
// The little of Embree that the renderer needs: owners of its handles and packets of 4 x 4 rays.
#pragma once

#include <embree3/rtcore.h>

#include <memory>

#include "graspdb/core/mesh.h"

namespace graspdb::embree {

// Bits of Embree's ray mask, by which a ray sees only one of the two bodies.
enum Visible : unsigned { kHandOnly = 1, kObjectOnly = 2, kEverything = 3 };

struct SceneReleaser {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using SceneHandle = std::unique_ptr<RTCSceneTy, SceneReleaser>;

// Geometry 0 is the hand, geometry 1 the object (if any). Built by the calling thread alone.
SceneHandle build_scene(const Mesh& hand, const Mesh* object);

// Embree wants denormal floats treated as zero; this restores the thread's mode at its end.
class FlushDenormals {
 public:
  FlushDenormals();
  ~FlushDenormals();
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  unsigned before_;
};

// A context for packets of neighbouring rays, which Embree traces about twice as fast as scattered
// ones.
RTCIntersectContext coherent_context();

}  // namespace graspdb::embree
