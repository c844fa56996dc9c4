// SPDX-License-Identifier: MIT
#include "scene.h"

#include "graspdb/core/error.h"

namespace graspdb {
namespace {

Surface make_surface(const Mesh& mesh, std::span<const float> openness) {
  Surface surface;
  surface.triangles = mesh.triangles;
  surface.positions = mesh.vertices;
  surface.facets = make_facets(mesh);
  surface.vertices.resize(mesh.vertices.size());
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    surface.vertices[v] = {mesh.normals[v], mesh.albedo.empty() ? 1.0F : mesh.albedo[v],
                           openness.empty() ? 1.0F : openness[v]};
  }
  return surface;
}

}  // namespace

Scene::Scene(const Mesh& hand, std::span<const std::uint8_t> hand_parts, const Mesh* object,
             std::span<const float> hand_openness)
    : state_(std::make_unique<State>()) {
  GRASPDB_CHECK(hand_parts.empty() || hand_parts.size() == hand.vertices.size());
  GRASPDB_CHECK(hand_openness.empty() || hand_openness.size() == hand.vertices.size());
  state_->embree = embree::build_scene(hand, object);
  state_->surfaces[0] = make_surface(hand, hand_openness);
  state_->surfaces[0].parts.assign(hand_parts.begin(), hand_parts.end());
  if (object != nullptr) state_->surfaces[1] = make_surface(*object, {});
}

Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;

}  // namespace graspdb
