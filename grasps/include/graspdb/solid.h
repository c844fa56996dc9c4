// SPDX-License-Identifier: MIT
// The solid objects that hands hold.
#pragma once

#include <Eigen/Core>
#include <memory>

#include "graspdb/mesh.h"

namespace graspdb {

// A closed solid in its own frame, metres; its centre is the origin and its long axis is z.
class Solid {
 public:
  virtual ~Solid() = default;
  // Signed distance to the surface, metres, negative inside; exact for primitives. Thread-safe.
  virtual double distance(const Eigen::Vector3d& point) const = 0;
  // A watertight mesh of the surface, with normals.
  virtual const Mesh& mesh() const = 0;
};

std::shared_ptr<const Solid> make_sphere(double diameter);
std::shared_ptr<const Solid> make_cylinder(double diameter, double length);  // disks are short ones
std::shared_ptr<const Solid> make_box(const Eigen::Vector3d& size);

}  // namespace graspdb
