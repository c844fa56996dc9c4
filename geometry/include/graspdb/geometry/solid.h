// SPDX-License-Identifier: MIT
// The solid objects that hands hold.
#pragma once

#include <Eigen/Core>
#include <memory>

#include "graspdb/core/mesh.h"

namespace graspdb {

// A closed solid in its own frame, metres; the centre of its box is the origin, and z is the axis
// of a cylinder or a ring. Safe to use from many threads.
class Solid {
 public:
  virtual ~Solid() = default;
  // Signed distance to the surface, metres, negative inside. Exact for primitives. For a mesh right
  // to 0.1 mm within 3 mm of the surface; beyond to 0.3 mm on the whole, and to 4 mm in places that
  // are as far from one side as from another. The sign is always right.
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
// A round wire bent into a circle; the inner diameter is that of the hole.
std::shared_ptr<const Solid> make_ring(double inner_diameter, double thickness);
// `factor` times as large, in all directions.
std::shared_ptr<const Solid> scaled(std::shared_ptr<const Solid> solid, double factor);

}  // namespace graspdb
