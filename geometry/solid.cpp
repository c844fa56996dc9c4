// SPDX-License-Identifier: MIT
#include "graspdb/geometry/solid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "graspdb/core/error.h"
#include "graspdb/core/transform.h"

namespace graspdb {
namespace {

constexpr int kSegments = 64;  // round a circle: at 100 mm across the facets are 0.06 mm deep
constexpr int kRings = kSegments / 2;
constexpr int kRingSides = 24;  // round the wire of a ring

std::uint32_t add_vertex(Mesh& mesh, const Eigen::Vector3d& position,
                         const Eigen::Vector3d& normal) {
  mesh.vertices.push_back(position.cast<float>());
  mesh.normals.push_back(normal.cast<float>());
  return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

// The direction of step `segment` round the z axis; the last one is the first one, to the bit.
Eigen::Vector3d around_z(int segment) {
  const double angle = 2 * kPi * (segment % kSegments) / kSegments;
  return {std::cos(angle), std::sin(angle), 0};
}

// Two rings of kSegments vertices each, the second one further along +z.
void add_band(Mesh& mesh, std::uint32_t lower, std::uint32_t upper) {
  for (std::uint32_t i = 0; i < kSegments; ++i) {
    const std::uint32_t next = (i + 1) % kSegments;
    mesh.triangles.push_back({lower + i, lower + next, upper + next});
    mesh.triangles.push_back({lower + i, upper + next, upper + i});
  }
}

// A fan from `centre` to a ring; `up` says whether it is seen from +z.
void add_fan(Mesh& mesh, std::uint32_t center, std::uint32_t ring, bool up) {
  for (std::uint32_t i = 0; i < kSegments; ++i) {
    const std::uint32_t next = (i + 1) % kSegments;
    mesh.triangles.push_back({center, ring + (up ? i : next), ring + (up ? next : i)});
  }
}

Mesh sphere_mesh(double radius) {
  Mesh mesh;
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  const std::uint32_t south = add_vertex(mesh, -radius * z, -z);
  for (int ring = 1; ring < kRings; ++ring) {
    const double latitude = kPi * (static_cast<double>(ring) / kRings - 0.5);
    for (int i = 0; i < kSegments; ++i) {
      const Eigen::Vector3d normal = std::cos(latitude) * around_z(i) + std::sin(latitude) * z;
      add_vertex(mesh, radius * normal, normal);
    }
  }
  const std::uint32_t north = add_vertex(mesh, radius * z, z);
  add_fan(mesh, south, 1, false);
  for (std::uint32_t ring = 0; ring + 2 < kRings; ++ring) {
    add_band(mesh, 1 + ring * kSegments, 1 + (ring + 1) * kSegments);
  }
  add_fan(mesh, north, north - kSegments, true);
  return mesh;
}

std::uint32_t add_ring(Mesh& mesh, double radius, double height, const Eigen::Vector3d* normal) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (int i = 0; i < kSegments; ++i) {
    const Eigen::Vector3d out = around_z(i);
    add_vertex(mesh, radius * out + height * Eigen::Vector3d::UnitZ(), normal ? *normal : out);
  }
  return first;
}

Mesh cylinder_mesh(double radius, double half_length) {
  Mesh mesh;
  const std::uint32_t lower = add_ring(mesh, radius, -half_length, nullptr);
  add_band(mesh, lower, add_ring(mesh, radius, half_length, nullptr));
  for (const double side : {-1.0, 1.0}) {
    const Eigen::Vector3d normal = side * Eigen::Vector3d::UnitZ();
    const std::uint32_t center = add_vertex(mesh, half_length * normal, normal);
    add_fan(mesh, center, add_ring(mesh, radius, side * half_length, &normal), side > 0);
  }
  return mesh;
}

Mesh box_mesh(const Eigen::Vector3d& half) {
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      const Eigen::Vector3d normal = side * Eigen::Vector3d::Unit(axis);
      const Eigen::Vector3d u = side * Eigen::Vector3d::Unit((axis + 1) % 3);
      const Eigen::Vector3d v = Eigen::Vector3d::Unit((axis + 2) % 3);  // u x v = normal
      const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
      for (const auto& [a, b] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
        add_vertex(mesh, half.cwiseProduct(normal + a * u + b * v), normal);
      }
      mesh.triangles.push_back({first, first + 1, first + 2});
      mesh.triangles.push_back({first, first + 2, first + 3});
    }
  }
  return mesh;
}

// Round the z axis; `radius` is that of the middle of the wire.
Mesh ring_mesh(double radius, double wire_radius) {
  Mesh mesh;
  for (int i = 0; i < kSegments; ++i) {
    const Eigen::Vector3d out = around_z(i);
    for (int j = 0; j < kRingSides; ++j) {
      const double angle = 2 * kPi * j / kRingSides;
      const Eigen::Vector3d normal =
          std::cos(angle) * out + std::sin(angle) * Eigen::Vector3d::UnitZ();
      add_vertex(mesh, radius * out + wire_radius * normal, normal);
    }
  }
  for (std::uint32_t i = 0; i < kSegments; ++i) {
    const std::uint32_t here = i * kRingSides, next = (i + 1) % kSegments * kRingSides;
    for (std::uint32_t j = 0; j < kRingSides; ++j) {
      const std::uint32_t above = (j + 1) % kRingSides;
      mesh.triangles.push_back({here + j, next + j, next + above});
      mesh.triangles.push_back({here + j, next + above, here + above});
    }
  }
  return mesh;
}

// The distance to a shape whose signed distances along independent directions are `d`.
template <typename Vector>
double combine(const Vector& d) {
  return std::min(d.maxCoeff(), 0.0) + d.cwiseMax(0.0).norm();
}

class Sphere final : public Solid {
 public:
  explicit Sphere(double radius) : radius_(radius), mesh_(sphere_mesh(radius)) {}
  double distance(const Eigen::Vector3d& point) const override { return point.norm() - radius_; }
  Eigen::Vector3d half_extents() const override { return Eigen::Vector3d::Constant(radius_); }
  const Mesh& mesh() const override { return mesh_; }

 private:
  double radius_;
  Mesh mesh_;
};

class Cylinder final : public Solid {
 public:
  Cylinder(double radius, double half_length)
      : radius_(radius), half_length_(half_length), mesh_(cylinder_mesh(radius, half_length)) {}
  double distance(const Eigen::Vector3d& point) const override {
    return combine(Eigen::Vector2d(std::hypot(point.x(), point.y()) - radius_,
                                   std::abs(point.z()) - half_length_));
  }
  Eigen::Vector3d half_extents() const override { return {radius_, radius_, half_length_}; }
  const Mesh& mesh() const override { return mesh_; }

 private:
  double radius_;
  double half_length_;
  Mesh mesh_;
};

class BoxSolid final : public Solid {
 public:
  explicit BoxSolid(const Eigen::Vector3d& half) : half_(half), mesh_(box_mesh(half)) {}
  double distance(const Eigen::Vector3d& point) const override {
    return combine(Eigen::Vector3d(point.cwiseAbs() - half_));
  }
  Eigen::Vector3d half_extents() const override { return half_; }
  const Mesh& mesh() const override { return mesh_; }

 private:
  Eigen::Vector3d half_;
  Mesh mesh_;
};

class Ring final : public Solid {
 public:
  Ring(double radius, double wire_radius)
      : radius_(radius), wire_radius_(wire_radius), mesh_(ring_mesh(radius, wire_radius)) {}
  double distance(const Eigen::Vector3d& point) const override {
    return std::hypot(std::hypot(point.x(), point.y()) - radius_, point.z()) - wire_radius_;
  }
  Eigen::Vector3d half_extents() const override {
    return {radius_ + wire_radius_, radius_ + wire_radius_, wire_radius_};
  }
  const Mesh& mesh() const override { return mesh_; }

 private:
  double radius_;
  double wire_radius_;
  Mesh mesh_;
};

class Scaled final : public Solid {
 public:
  Scaled(std::shared_ptr<const Solid> solid, double factor)
      : solid_(std::move(solid)), factor_(factor), mesh_(solid_->mesh()) {
    for (Eigen::Vector3f& vertex : mesh_.vertices) vertex *= static_cast<float>(factor);
  }
  double distance(const Eigen::Vector3d& point) const override {
    return factor_ * solid_->distance(point / factor_);
  }
  Eigen::Vector3d half_extents() const override { return factor_ * solid_->half_extents(); }
  const Mesh& mesh() const override { return mesh_; }

 private:
  std::shared_ptr<const Solid> solid_;
  double factor_;
  Mesh mesh_;
};

}  // namespace

std::shared_ptr<const Solid> make_sphere(double diameter) {
  GRASPDB_CHECK(diameter > 0);
  return std::make_shared<Sphere>(diameter / 2);
}

std::shared_ptr<const Solid> make_cylinder(double diameter, double length) {
  GRASPDB_CHECK(diameter > 0 && length > 0);
  return std::make_shared<Cylinder>(diameter / 2, length / 2);
}

std::shared_ptr<const Solid> make_box(const Eigen::Vector3d& size) {
  GRASPDB_CHECK(size.minCoeff() > 0);
  return std::make_shared<BoxSolid>(size / 2);
}

std::shared_ptr<const Solid> make_ring(double inner_diameter, double thickness) {
  GRASPDB_CHECK(inner_diameter > 0 && thickness > 0);
  return std::make_shared<Ring>((inner_diameter + thickness) / 2, thickness / 2);
}

std::shared_ptr<const Solid> scaled(std::shared_ptr<const Solid> solid, double factor) {
  GRASPDB_CHECK(solid != nullptr && factor > 0);
  return std::make_shared<Scaled>(std::move(solid), factor);
}

}  // namespace graspdb
