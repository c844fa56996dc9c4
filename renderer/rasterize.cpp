// SPDX-License-Identifier: MIT
#include <array>
#include <vector>

#include "graspdb/core/error.h"
#include "projection.h"
#include "scene.h"
#include "triangle_raster.h"

namespace graspdb {
namespace {

// Pixel coordinates of what is nearer would be too large for floats; and behind the camera, wrong.
constexpr float kNearestRasterized = 0.02F;  // metres

}  // namespace

View rasterize(const Scene& scene, const Camera& camera, const Light& light) {
  const int width = camera.intrinsics.width, height = camera.intrinsics.height;
  GRASPDB_CHECK(width > 0 && height > 0);
  const auto& [hand, object] = scene.state().surfaces;
  std::array<std::vector<ProjectedVertex>, 2> seen;
  for (std::size_t body = 0; body < seen.size(); ++body) {
    const std::vector<Eigen::Vector3f>& positions = scene.state().surfaces[body].positions;
    seen[body].resize(positions.size());
    if (project_vertices(positions, camera, seen[body]) < kNearestRasterized) {
      return render(scene, camera, light);
    }
  }
  View view;
  view.shading = GrayImage(width, height);
  view.label = Image<std::uint8_t>(width, height);
  const std::array<RasterSurface, 2> surfaces = {
      {{hand.facets, hand.vertices, seen[0], kHandSurface},
       {object.facets, object.vertices, seen[1], kObjectSurface}}};
  const Eigen::Vector3d eye = camera.camera_from_hand.inverse().translation;
  draw_surfaces(surfaces, eye.cast<float>(), HandLight(light, camera), view);
  return view;
}

}  // namespace graspdb
