// SPDX-License-Identifier: MIT
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "graspdb/core/error.h"
#include "packet.h"
#include "scene.h"
#include "shading.h"

namespace graspdb {
namespace {

// One hit of a packet with all that the layers want to know of it.
struct Hit {
  unsigned geometry;
  float u, v;
  const Surface& surface;
  const Triangle& triangle;
};

struct InterpolatedVertex {
  Eigen::Vector3f normal;  // unit, hand frame
  float albedo;
  float openness;
};

InterpolatedVertex interpolate(const Hit& hit) {
  const ShadingVertex& a = hit.surface.vertices[hit.triangle[0]];
  const ShadingVertex& b = hit.surface.vertices[hit.triangle[1]];
  const ShadingVertex& c = hit.surface.vertices[hit.triangle[2]];
  const float w = 1.0F - hit.u - hit.v;
  return {(w * a.normal + hit.u * b.normal + hit.v * c.normal).normalized(),
          w * a.albedo + hit.u * b.albedo + hit.v * c.albedo,
          w * a.openness + hit.u * b.openness + hit.v * c.openness};
}

std::uint8_t shade(const HandLight& light, const InterpolatedVertex& at) {
  const float lit = std::max(0.0F, at.normal.dot(light.towards) + light.softness);
  const float gray = 255.0F * at.albedo * (light.ambient * at.openness + light.diffuse * lit);
  // NOLINTNEXTLINE(bugprone-incorrect-roundings): never negative
  return static_cast<std::uint8_t>(std::clamp(gray, 0.0F, 255.0F) + 0.5F);
}

class Renderer {
 public:
  Renderer(const Scene::State& scene, const Camera& camera, const Light& light,
           const Layers& layers);
  View run();

 private:
  void trace_tile(int x, int y);
  void write_pixel(int x, int y, const Hit& hit, float depth);
  void trace_mask(embree::Visible body, Mask& mask);

  const Scene::State& scene_;
  const PixelRays rays_;
  const HandLight light_;
  const Eigen::Matrix3f rotation_;
  const Layers layers_;
  const int width_, height_;
  RTCIntersectContext context_ = embree::coherent_context();
  alignas(64) RTCRayHit16 packet_;
  alignas(64) std::array<int, PixelRays::kLanes> valid_;
  View view_;
};

Renderer::Renderer(const Scene::State& scene, const Camera& camera, const Light& light,
                   const Layers& layers)
    : scene_(scene),
      rays_(camera),
      light_(light, camera),
      rotation_(camera.camera_from_hand.rotation.cast<float>()),
      layers_(layers),
      width_(camera.intrinsics.width),
      height_(camera.intrinsics.height) {
  GRASPDB_CHECK(width_ > 0 && height_ > 0);
  view_.shading = GrayImage(width_, height_);
  view_.label = Image<std::uint8_t>(width_, height_);
  if (layers.depth) {
    view_.depth = Image<float>(width_, height_, std::numeric_limits<float>::infinity());
  }
  if (layers.normals) {
    view_.normal = Image<Eigen::Vector3f>(width_, height_, Eigen::Vector3f::Zero());
  }
  if (layers.parts) view_.part = Image<std::uint8_t>(width_, height_);
}

View Renderer::run() {
  const embree::FlushDenormals flush;
  for (int y = 0; y < height_; y += PixelRays::kTile) {
    for (int x = 0; x < width_; x += PixelRays::kTile) trace_tile(x, y);
  }
  if (layers_.amodal) {
    trace_mask(embree::kHandOnly, view_.hand_amodal);
    trace_mask(embree::kObjectOnly, view_.object_amodal);
  }
  return std::move(view_);
}

void Renderer::trace_tile(int x, int y) {
  rays_.aim(x, y, embree::kEverything, packet_.ray);
  rays_.mark_valid(x, y, valid_);
  std::fill_n(packet_.hit.geomID, PixelRays::kLanes, RTC_INVALID_GEOMETRY_ID);
  rtcIntersect16(valid_.data(), scene_.embree.get(), &context_, &packet_);
  for (int i = 0; i < PixelRays::kLanes; ++i) {
    const unsigned geometry = packet_.hit.geomID[i];
    if (geometry == RTC_INVALID_GEOMETRY_ID) continue;
    const Surface& surface = scene_.surfaces[geometry];
    const Hit hit{geometry, packet_.hit.u[i], packet_.hit.v[i], surface,
                  surface.triangles[packet_.hit.primID[i]]};
    write_pixel(x + i % PixelRays::kTile, y + i / PixelRays::kTile, hit, packet_.ray.tfar[i]);
  }
}

void Renderer::write_pixel(int x, int y, const Hit& hit, float depth) {
  const InterpolatedVertex at = interpolate(hit);
  view_.shading.at(x, y) = shade(light_, at);
  view_.label.at(x, y) = hit.geometry == 0 ? kHandSurface : kObjectSurface;
  if (layers_.depth) view_.depth.at(x, y) = depth;
  if (layers_.normals) view_.normal.at(x, y) = rotation_ * at.normal;
  if (layers_.parts && hit.geometry == 0) {
    const auto& parts = hit.surface.parts;
    const int part = parts.empty() ? 0 : parts[hit.triangle[0]];
    view_.part.at(x, y) = static_cast<std::uint8_t>(part + 1);
  }
}

void Renderer::trace_mask(embree::Visible body, Mask& mask) {
  mask = Mask(width_, height_);
  for (int y = 0; y < height_; y += PixelRays::kTile) {
    for (int x = 0; x < width_; x += PixelRays::kTile) {
      rays_.aim(x, y, body, packet_.ray);
      rays_.mark_valid(x, y, valid_);
      rtcOccluded16(valid_.data(), scene_.embree.get(), &context_, &packet_.ray);
      for (int i = 0; i < PixelRays::kLanes; ++i) {
        // Embree marks an occluded ray by a far end of minus infinity.
        if (packet_.ray.tfar[i] >= 0) continue;
        mask.at(x + i % PixelRays::kTile, y + i / PixelRays::kTile) = 255;
      }
    }
  }
}

}  // namespace

View render(const Scene& scene, const Camera& camera, const Light& light, const Layers& layers) {
  return Renderer(scene.state(), camera, light, layers).run();
}

Mask visible_hand(const View& view) {
  Mask mask(view.label.width(), view.label.height());
  std::transform(view.label.begin(), view.label.end(), mask.begin(), [](std::uint8_t label) {
    return static_cast<std::uint8_t>(label == kHandSurface ? 255 : 0);
  });
  return mask;
}

}  // namespace graspdb
