// SPDX-License-Identifier: MIT
// The open end of a forearm, and what tells it from any other hole.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rig_skin.h"

namespace graspdb {

// A ring of vertices seen along the forearm; `elbow` is a unit vector. Metres.
class Rim {
 public:
  Rim(const std::vector<std::uint32_t>& loop, const Eigen::Vector3d& elbow, const Mesh& mesh)
      : elbow_(elbow) {
    const auto count = static_cast<double>(loop.size());
    for (const std::uint32_t v : loop) center_ += mesh.vertices[v].cast<double>() / count;
    for (const std::uint32_t v : loop) {
      radius_ += across(mesh.vertices[v].cast<double>()).norm() / count;
    }
  }

  const Eigen::Vector3d& center() const { return center_; }
  double radius() const { return radius_; }
  Eigen::Vector3d across(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d from_center = point - center_;
    return from_center - elbow_ * elbow_.dot(from_center);
  }

 private:
  Eigen::Vector3d elbow_, center_ = Eigen::Vector3d::Zero();
  double radius_ = 0;
};

// Why a loop of open edges is not where the forearm ends: it is when it lies beyond the wrist,
// round the forearm's axis, on skin that palm and forearm move, and none of the skin of `triangles`
// is nearer to the elbow, or wide around it. Nothing when it is.
std::optional<std::string> fault_of_rim(const std::vector<std::uint32_t>& loop,
                                        const Eigen::Vector3d& elbow,
                                        const std::vector<Triangle>& triangles,
                                        const RigSkin& skin);

}  // namespace graspdb
