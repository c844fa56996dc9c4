// SPDX-License-Identifier: MIT
// Compiled once for each instruction set; the best one that the processor has is chosen when the
// program runs.
#include "triangle_raster.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "triangle_raster.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace graspdb {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, 16>;
using Ints = hn::RebindToSigned<Floats>;
using Indices = hn::RebindToUnsigned<Floats>;
using Vec = hn::Vec<Floats>;

// A vector holds a tile of up to 4 x 4 pixels: most triangles of a hand cover two or three.
HWY_INLINE int TileWidth() {
  return std::min(4, static_cast<int>(hn::Lanes(Floats())));
}
HWY_INLINE int TileHeight() {
  return static_cast<int>(hn::Lanes(Floats())) / TileWidth();
}

struct Corner {
  const ProjectedVertex& seen;
  const ShadingVertex& shading;
};

// The three corners' shares of a pixel, up to a common factor: on the picture, and in space.
struct Weights {
  Vec flat[3];
  Vec in_space[3];
};

HWY_INLINE Vec Cross(Vec ax, Vec ay, Vec bx, Vec by) {
  return hn::Sub(hn::Mul(ax, by), hn::Mul(ay, bx));
}

HWY_INLINE Vec Sum(const Vec (&of)[3]) {
  return hn::Add(hn::Add(of[0], of[1]), of[2]);
}

HWY_INLINE Vec Dot(const Vec (&of)[3], float a, float b, float c) {
  const Floats f;
  return hn::Add(hn::Add(hn::Mul(of[0], hn::Set(f, a)), hn::Mul(of[1], hn::Set(f, b))),
                 hn::Mul(of[2], hn::Set(f, c)));
}

HWY_INLINE Weights WeightsAt(const Corner (&corners)[3], Vec x, Vec y) {
  const Floats f;
  Vec dx[3], dy[3];
  for (int i = 0; i < 3; ++i) {
    dx[i] = hn::Sub(hn::Set(f, corners[i].seen.x), x);
    dy[i] = hn::Sub(hn::Set(f, corners[i].seen.y), y);
  }
  Weights weights;
  for (int i = 0; i < 3; ++i) {
    // The mesh runs counter-clockwise, but the picture's y points down.
    const int j = (i + 2) % 3, k = (i + 1) % 3;
    weights.flat[i] = Cross(dx[j], dy[j], dx[k], dy[k]);
    weights.in_space[i] = hn::Mul(weights.flat[i], hn::Set(f, corners[i].seen.inverse_z));
  }
  return weights;
}

// As render() shades: interpolated albedo and openness, interpolated normal made a unit vector. The
// weights' common factor goes out at the end, together with the normal's length.
HWY_INLINE hn::Vec<Ints> Grey(const Corner (&corners)[3], const Weights& weights,
                              const HandLight& light) {
  const Floats f;
  const ShadingVertex &a = corners[0].shading, &b = corners[1].shading, &c = corners[2].shading;
  const auto& w = weights.in_space;
  const Vec normal[3] = {Dot(w, a.normal.x(), b.normal.x(), c.normal.x()),
                         Dot(w, a.normal.y(), b.normal.y(), c.normal.y()),
                         Dot(w, a.normal.z(), b.normal.z(), c.normal.z())};
  const Vec squares[3] = {hn::Mul(normal[0], normal[0]), hn::Mul(normal[1], normal[1]),
                          hn::Mul(normal[2], normal[2])};
  const Vec length = hn::Sqrt(Sum(squares));
  const Vec cosine = Dot(normal, light.towards.x(), light.towards.y(), light.towards.z());
  const Vec sum = Sum(w);
  const Vec ambient = hn::Mul(hn::Mul(hn::Set(f, light.ambient), length),
                              Dot(w, a.openness, b.openness, c.openness));
  const Vec diffuse =
      hn::Mul(hn::Mul(hn::Set(f, light.diffuse), sum), hn::Max(cosine, hn::Zero(f)));
  const Vec albedo = hn::Mul(hn::Set(f, 255), Dot(w, a.albedo, b.albedo, c.albedo));
  const Vec grey =
      hn::Div(hn::Mul(albedo, hn::Add(ambient, diffuse)), hn::Mul(hn::Mul(sum, sum), length));
  const Vec clipped = hn::Min(hn::Max(grey, hn::Zero(f)), hn::Set(f, 255));
  return hn::ConvertTo(Ints(), hn::Add(clipped, hn::Set(f, 0.5F)));
}

// The first of the pixels 0, 1, 2, ... that is not left of `low`.
HWY_INLINE int FirstPixel(float low) {
  const float inside = std::max(low, 0.0F);
  const int truncated = static_cast<int>(inside);
  return truncated + static_cast<int>(static_cast<float>(truncated) < inside);
}

// The last of the pixels -1, 0, ..., size - 1 that is not right of `high`; -1 means none.
HWY_INLINE int LastPixel(float high, int size) {
  return static_cast<int>(std::clamp(high + 1, 0.0F, static_cast<float>(size))) - 1;
}

// The picture in the making, tile by tile.
class Canvas {
 public:
  Canvas(int width, int height)
      : tiles_across_((width + TileWidth() - 1) / TileWidth()),
        width_(width),
        height_(height),
        inverse_z_(Size(height)),
        pixels_(Size(height)) {}

  void Draw(const Corner (&corners)[3], const HandLight& light, SurfaceLabel label) {
    const auto& [a, b, c] = corners;
    const int left = FirstPixel(std::min({a.seen.x, b.seen.x, c.seen.x}));
    const int right = LastPixel(std::max({a.seen.x, b.seen.x, c.seen.x}), width_);
    const int top = FirstPixel(std::min({a.seen.y, b.seen.y, c.seen.y}));
    const int bottom = LastPixel(std::max({a.seen.y, b.seen.y, c.seen.y}), height_);
    if (left > right || top > bottom) return;
    for (int row = top / TileHeight(); row <= bottom / TileHeight(); ++row) {
      for (int column = left / TileWidth(); column <= right / TileWidth(); ++column) {
        DrawTile(corners, light, label, column, row);
      }
    }
  }

  void Copy(View& view) const {
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        const int lane = y % TileHeight() * TileWidth() + x % TileWidth();
        const std::int32_t pixel =
            pixels_[Place(x / TileWidth(), y / TileHeight()) + static_cast<std::size_t>(lane)];
        view.shading.at(x, y) = static_cast<std::uint8_t>(pixel);
        view.label.at(x, y) = static_cast<std::uint8_t>(pixel >> 8);
      }
    }
  }

 private:
  std::size_t Size(int height) const {
    return Place(0, (height + TileHeight() - 1) / TileHeight());
  }
  std::size_t Place(int column, int row) const {
    return static_cast<std::size_t>(row * tiles_across_ + column) * hn::Lanes(Floats());
  }

  HWY_INLINE void DrawTile(const Corner (&corners)[3], const HandLight& light, SurfaceLabel label,
                           int column, int row) {
    const Floats f;
    const Ints ints;
    const auto lane = hn::Iota(ints, 0);
    const Vec x = hn::Add(hn::ConvertTo(f, hn::And(lane, hn::Set(ints, 3))),
                          hn::Set(f, static_cast<float>(column * TileWidth())));
    const Vec y = hn::Add(hn::ConvertTo(f, hn::ShiftRight<2>(lane)),
                          hn::Set(f, static_cast<float>(row * TileHeight())));
    const Weights weights = WeightsAt(corners, x, y);
    const auto& w = weights.flat;
    const auto covered = hn::Ge(hn::Min(hn::Min(w[0], w[1]), w[2]), hn::Zero(f));
    const Vec inverse_z = hn::Div(Sum(weights.in_space), Sum(w));
    float* held_z = inverse_z_.data() + Place(column, row);
    const Vec before = hn::LoadU(f, held_z);
    const auto nearer = hn::And(covered, hn::Gt(inverse_z, before));
    if (hn::AllFalse(f, nearer)) return;
    hn::StoreU(hn::IfThenElse(nearer, inverse_z, before), f, held_z);
    std::int32_t* held = pixels_.data() + Place(column, row);
    const auto pixel = hn::Add(Grey(corners, weights, light), hn::Set(ints, label << 8));
    hn::StoreU(hn::IfThenElse(hn::RebindMask(ints, nearer), pixel, hn::LoadU(ints, held)), ints,
               held);
  }

  int tiles_across_, width_, height_;
  std::vector<float> inverse_z_;      // 0 where nothing has been drawn
  std::vector<std::int32_t> pixels_;  // label * 256 + grey
};

// Numbers of the facets that face the eye.
std::vector<std::uint32_t> FacingTriangles(const Facets& facets, const Eigen::Vector3f& eye) {
  const Floats f;
  const Indices indices;
  const std::size_t lanes = hn::Lanes(f);
  std::vector<std::uint32_t> facing(facets.offset.size() + lanes);
  std::size_t count = 0;
  for (std::size_t i = 0; i < facets.offset.size(); i += lanes) {
    const Vec normal[3] = {hn::LoadU(f, facets.normal[0].data() + i),
                           hn::LoadU(f, facets.normal[1].data() + i),
                           hn::LoadU(f, facets.normal[2].data() + i)};
    const auto outside =
        hn::Gt(Dot(normal, eye.x(), eye.y(), eye.z()), hn::LoadU(f, facets.offset.data() + i));
    count += hn::CompressStore(hn::Iota(indices, static_cast<std::uint32_t>(i)),
                               hn::RebindMask(indices, outside), indices, facing.data() + count);
  }
  facing.resize(count);
  return facing;
}

void DrawSurfaces(std::span<const RasterSurface> surfaces, const Eigen::Vector3f& eye,
                  const HandLight& light, View& view) {
  Canvas canvas(view.label.width(), view.label.height());
  for (const RasterSurface& surface : surfaces) {
    for (const std::uint32_t triangle : FacingTriangles(surface.facets, eye)) {
      const auto [a, b, c] = surface.facets.triangles[triangle];
      canvas.Draw({{surface.seen[a], surface.shading[a]},
                   {surface.seen[b], surface.shading[b]},
                   {surface.seen[c], surface.shading[c]}},
                  light, surface.label);
    }
  }
  canvas.Copy(view);
}

}  // namespace HWY_NAMESPACE
}  // namespace graspdb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graspdb {

HWY_EXPORT(DrawSurfaces);

void draw_surfaces(std::span<const RasterSurface> surfaces, const Eigen::Vector3f& eye_in_hand,
                   const HandLight& light, View& view) {
  HWY_DYNAMIC_DISPATCH(DrawSurfaces)(surfaces, eye_in_hand, light, view);
}

}  // namespace graspdb
#endif
