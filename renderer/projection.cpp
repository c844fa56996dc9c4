// SPDX-License-Identifier: MIT
// Compiled once for each instruction set; see triangle_raster.cpp.
#include "projection.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "projection.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <limits>

#include "graspdb/core/error.h"

HWY_BEFORE_NAMESPACE();
namespace graspdb {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, 16>;
using Vec = hn::Vec<Floats>;
constexpr std::size_t kMostLanes = 16;

// Calls body(x, y, z, first, count) with the camera's coordinates of `count` vertices at a time, as
// many as a vector has lanes; lanes beyond the last vertex repeat it.
template <typename Body>
HWY_INLINE void ForEachBlock(std::span<const Eigen::Vector3f> vertices,
                             const RigidTransform& camera_from_hand, const Body& body) {
  const Floats f;
  const Eigen::Matrix3f r = camera_from_hand.rotation.cast<float>();
  const Eigen::Vector3f t = camera_from_hand.translation.cast<float>();
  const std::size_t lanes = hn::Lanes(f);
  std::array<Eigen::Vector3f, kMostLanes> last;
  for (std::size_t first = 0; first < vertices.size(); first += lanes) {
    const std::size_t count = std::min(lanes, vertices.size() - first);
    const Eigen::Vector3f* block = vertices.data() + first;
    if (count < lanes) {
      last.fill(vertices.back());
      block = std::copy_n(block, count, last.data()) - count;
    }
    Vec x, y, z;
    hn::LoadInterleaved3(f, block->data(), x, y, z);
    const auto row = [&](int i) HWY_ATTR {
      const Vec xy = hn::Add(hn::Mul(hn::Set(f, r(i, 0)), x), hn::Mul(hn::Set(f, r(i, 1)), y));
      return hn::Add(hn::Add(xy, hn::Mul(hn::Set(f, r(i, 2)), z)), hn::Set(f, t(i)));
    };
    body(row(0), row(1), row(2), first, count);
  }
}

TangentBounds Bounds(std::span<const Eigen::Vector3f> vertices,
                     const RigidTransform& camera_from_hand) {
  const Floats f;
  const Vec infinity = hn::Set(f, std::numeric_limits<float>::infinity());
  Vec low_x = infinity, low_y = infinity, nearest = infinity;
  Vec high_x = hn::Neg(infinity), high_y = high_x;
  ForEachBlock(vertices, camera_from_hand,
               [&](Vec x, Vec y, Vec z, std::size_t, std::size_t) HWY_ATTR {
                 const Vec tangent_x = hn::Div(x, z), tangent_y = hn::Div(y, z);
                 low_x = hn::Min(low_x, tangent_x);
                 low_y = hn::Min(low_y, tangent_y);
                 high_x = hn::Max(high_x, tangent_x);
                 high_y = hn::Max(high_y, tangent_y);
                 nearest = hn::Min(nearest, z);
               });
  const auto least = [&](Vec v) HWY_ATTR { return hn::GetLane(hn::MinOfLanes(f, v)); };
  const auto most = [&](Vec v) HWY_ATTR { return hn::GetLane(hn::MaxOfLanes(f, v)); };
  return {{least(low_x), least(low_y)}, {most(high_x), most(high_y)}, least(nearest)};
}

float Project(std::span<const Eigen::Vector3f> vertices, const Camera& camera,
              std::span<ProjectedVertex> projected) {
  const Floats f;
  const Intrinsics& k = camera.intrinsics;
  const Vec fx = hn::Set(f, static_cast<float>(k.fx)), fy = hn::Set(f, static_cast<float>(k.fy));
  const Vec cx = hn::Set(f, static_cast<float>(k.cx)), cy = hn::Set(f, static_cast<float>(k.cy));
  Vec nearest = hn::Set(f, std::numeric_limits<float>::infinity());
  ForEachBlock(vertices, camera.camera_from_hand,
               [&](Vec x, Vec y, Vec z, std::size_t first, std::size_t count) HWY_ATTR {
                 nearest = hn::Min(nearest, z);
                 const Vec inverse_z = hn::Div(hn::Set(f, 1.0F), z);
                 const Vec u = hn::Add(hn::Mul(hn::Mul(x, fx), inverse_z), cx);
                 const Vec v = hn::Add(hn::Mul(hn::Mul(y, fy), inverse_z), cy);
                 std::array<ProjectedVertex, kMostLanes> block;
                 hn::StoreInterleaved3(u, v, inverse_z, f, &block[0].x);
                 std::copy_n(block.data(), count, projected.data() + first);
               });
  return hn::GetLane(hn::MinOfLanes(f, nearest));
}

}  // namespace HWY_NAMESPACE
}  // namespace graspdb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graspdb {

HWY_EXPORT(Bounds);
HWY_EXPORT(Project);

TangentBounds tangent_bounds(std::span<const Eigen::Vector3f> vertices,
                             const RigidTransform& camera_from_hand) {
  return HWY_DYNAMIC_DISPATCH(Bounds)(vertices, camera_from_hand);
}

float project_vertices(std::span<const Eigen::Vector3f> vertices, const Camera& camera,
                       std::span<ProjectedVertex> projected) {
  GRASPDB_CHECK(projected.size() == vertices.size());
  return HWY_DYNAMIC_DISPATCH(Project)(vertices, camera, projected);
}

}  // namespace graspdb
#endif
