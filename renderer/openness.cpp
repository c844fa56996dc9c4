// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "graspdb/core/error.h"
#include "graspdb/core/transform.h"
#include "scene.h"

namespace graspdb {
namespace {

constexpr std::size_t kLanes = 16;

// Points of the Fibonacci lattice, which spreads any number of them evenly over the sphere.
std::vector<Eigen::Vector3f> sphere_directions(int count) {
  const double golden_angle = kPi * (3 - std::sqrt(5.0));
  std::vector<Eigen::Vector3f> directions;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count;
    const double radius = std::sqrt(1 - z * z);
    directions.push_back(
        Eigen::Vector3d(radius * std::cos(golden_angle * i), radius * std::sin(golden_angle * i), z)
            .cast<float>());
  }
  return directions;
}

// The rays of one vertex, traced 16 at a time.
class Hemisphere {
 public:
  Hemisphere(RTCScene scene, double reach) : scene_(scene), reach_(static_cast<float>(reach)) {
    rtcInitIntersectContext(&context_);  // scattered rays: the coherent flag slows them by a fifth
  }

  float openness(const Eigen::Vector3f& vertex, const Eigen::Vector3f& normal,
                 const std::vector<Eigen::Vector3f>& directions) {
    open_ = all_ = 0;
    // Start a little outside, so that the rays miss the triangles of their own vertex.
    const Eigen::Vector3f origin = vertex + 2e-4F * normal;
    for (const Eigen::Vector3f& direction : directions) {
      const float cosine = normal.dot(direction);
      if (cosine > 0) add(origin, direction, cosine);
    }
    trace();
    return all_ > 0 ? open_ / all_ : 1.0F;
  }

 private:
  void add(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float cosine) {
    const std::size_t i = used_++;
    rays_.org_x[i] = origin.x();
    rays_.org_y[i] = origin.y();
    rays_.org_z[i] = origin.z();
    rays_.dir_x[i] = direction.x();
    rays_.dir_y[i] = direction.y();
    rays_.dir_z[i] = direction.z();
    rays_.tnear[i] = 0;
    rays_.tfar[i] = reach_;
    rays_.time[i] = 0;
    rays_.mask[i] = embree::kEverything;
    cosines_[i] = cosine;
    if (used_ == kLanes) trace();
  }

  void trace() {
    alignas(64) std::array<int, kLanes> valid{};
    std::fill_n(valid.begin(), used_, -1);
    rtcOccluded16(valid.data(), scene_, &context_, &rays_);
    for (std::size_t i = 0; i < used_; ++i) {
      all_ += cosines_[i];
      if (rays_.tfar[i] >= 0) open_ += cosines_[i];
    }
    used_ = 0;
  }

  RTCScene scene_;
  float reach_;
  RTCIntersectContext context_;
  alignas(64) RTCRay16 rays_{};
  std::array<float, kLanes> cosines_{};
  std::size_t used_ = 0;
  float open_ = 0;
  float all_ = 0;
};

}  // namespace

std::vector<float> ambient_openness(const Mesh& hand, const Mesh* object, int rays, double reach) {
  GRASPDB_CHECK(rays > 0 && reach > 0);
  const embree::SceneHandle scene = embree::build_scene(hand, object);
  const embree::FlushDenormals flush;
  const std::vector<Eigen::Vector3f> directions = sphere_directions(2 * rays);
  Hemisphere hemisphere(scene.get(), reach);
  std::vector<float> openness(hand.vertices.size());
  for (std::size_t v = 0; v < openness.size(); ++v) {
    openness[v] = hemisphere.openness(hand.vertices[v], hand.normals[v], directions);
  }
  return openness;
}

}  // namespace graspdb
