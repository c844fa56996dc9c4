// SPDX-License-Identifier: MIT
// The solid objects that hands hold.
#pragma once

#include <Eigen/Core>
#include <memory>

#include "graspdb/mesh.h"

namespace graspdb {

// A closed solid in its own frame, metres; its centre is the origin and a cylinder's axis is z.
// Immutable, and so safe to use from many threads.
class Solid {
 public:
  virtual ~Solid() = default;
  // Signed distance to the surface, metres, negative inside; exact for primitives.
  virtual double distance(const Eigen::Vector3d& point) const = 0;
  // Half the sides of the smallest box around it that is aligned to its axes, metres.
  virtual Eigen::Vector3d half_extents() const = 0;
  // A watertight mesh of the surface, with normals. Vertices are doubled along sharp edges, so that
  // it is closed by position, not by index.
  virtual const Mesh& mesh() const = 0;
};

// All sizes are in metres and above 0.
std::shared_ptr<const Solid> make_sphere(double diameter);
std::shared_ptr<const Solid> make_cylinder(double diameter, double length);  // disks are short ones
std::shared_ptr<const Solid> make_box(const Eigen::Vector3d& size);

}  // namespace graspdb
