// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "graspdb/renderer/renderer.h"

namespace graspdb {

// The light in the hand frame, where the normals are.
struct HandLight {
  float ambient = 0;
  float diffuse = 0;  // of cosine + softness
  float softness = 0;
  Eigen::Vector3f towards;

  HandLight(const Light& light, const Camera& camera)
      : ambient(static_cast<float>(light.ambient)),
        diffuse(static_cast<float>(light.diffuse / (1 + light.softness))),
        softness(static_cast<float>(light.softness)) {
    const Eigen::Vector3d in_camera = light.towards_light_in_camera.normalized();
    towards = (camera.camera_from_hand.rotation.transpose() * in_camera).cast<float>();
  }
};

}  // namespace graspdb
