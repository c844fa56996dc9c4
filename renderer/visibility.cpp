// SPDX-License-Identifier: MIT
#include <limits>

#include "graspdb/core/error.h"
#include "scene.h"

namespace graspdb {
namespace {

// A ray whose parameter is 0 at `from` and 1 at `to`.
RTCRayHit ray_between(const Eigen::Vector3f& from, const Eigen::Vector3f& to) {
  RTCRayHit ray{};
  ray.ray.org_x = from.x();
  ray.ray.org_y = from.y();
  ray.ray.org_z = from.z();
  ray.ray.dir_x = to.x() - from.x();
  ray.ray.dir_y = to.y() - from.y();
  ray.ray.dir_z = to.z() - from.z();
  ray.ray.tfar = 1;
  ray.ray.mask = embree::kEverything;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  return ray;
}

}  // namespace

bool inside_picture(const Intrinsics& k, const Eigen::Vector3d& in_camera) {
  if (in_camera.z() <= 0) return false;
  const Eigen::Vector2d pixel = k.project(in_camera);
  return pixel.x() >= -0.5 && pixel.x() < k.width - 0.5 && pixel.y() >= -0.5 &&
         pixel.y() < k.height - 0.5;
}

std::vector<bool> visible_points(const Scene& scene, const Camera& camera,
                                 std::span<const Eigen::Vector3d> points_in_hand,
                                 std::span<const double> radii) {
  GRASPDB_CHECK(radii.size() == points_in_hand.size());
  const embree::FlushDenormals flush;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  const Eigen::Vector3f eye = camera.camera_from_hand.inverse().translation.cast<float>();
  std::vector<bool> seen;
  for (std::size_t i = 0; i < points_in_hand.size(); ++i) {
    const Eigen::Vector3d& point = points_in_hand[i];
    const Eigen::Vector3d in_camera = camera.camera_from_hand * point;
    if (!inside_picture(camera.intrinsics, in_camera)) {
      seen.push_back(false);
      continue;
    }
    RTCRayHit ray = ray_between(eye, point.cast<float>());
    rtcIntersect1(scene.state().embree.get(), &context, &ray);
    const bool is_own_skin =
        ray.hit.geomID == 0 && ray.ray.tfar * in_camera.z() >= in_camera.z() - radii[i];
    seen.push_back(ray.hit.geomID == RTC_INVALID_GEOMETRY_ID || is_own_skin);
  }
  return seen;
}

}  // namespace graspdb
