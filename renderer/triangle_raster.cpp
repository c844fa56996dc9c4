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

// A vector holds a tile of 4 x 4 pixels, or fewer rows where it has fewer lanes: most triangles of
// a hand fit into one.
constexpr int kTileWidth = HWY_MIN(4, hn::MaxLanes(Floats()));

HWY_INLINE int TileHeight() {
  return static_cast<int>(hn::Lanes(Floats())) / kTileWidth;
}

// The rows of a tile lie `stride` elements apart in memory.
#if HWY_TARGET == HWY_SCALAR  // a tile is one pixel

template <class D, typename Element>
HWY_INLINE hn::Vec<D> LoadRows(D d, const Element* from, std::size_t) {
  return hn::Load(d, from);
}

template <class D, typename Element>
HWY_INLINE void StoreRows(D d, hn::Vec<D> tile, Element* to, std::size_t) {
  hn::Store(tile, d, to);
}

#else

template <class D, typename Element>
HWY_INLINE hn::Vec<D> LoadRows(D d, const Element* from, std::size_t stride) {
  if constexpr (hn::MaxLanes(D()) <= kTileWidth) {
    return hn::LoadU(d, from);
  } else {
    const hn::Half<D> half;
    const Element* lower = from + hn::Lanes(half) / kTileWidth * stride;
    return hn::Combine(d, LoadRows(half, lower, stride), LoadRows(half, from, stride));
  }
}

template <class D, typename Element>
HWY_INLINE void StoreRows(D d, hn::Vec<D> tile, Element* to, std::size_t stride) {
  if constexpr (hn::MaxLanes(D()) <= kTileWidth) {
    hn::StoreU(tile, d, to);
  } else {
    const hn::Half<D> half;
    StoreRows(half, hn::LowerHalf(half, tile), to, stride);
    StoreRows(half, hn::UpperHalf(half, tile), to + hn::Lanes(half) / kTileWidth * stride, stride);
  }
}

#endif

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
HWY_INLINE hn::Vec<Ints> Gray(const Corner (&corners)[3], const Weights& weights,
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
  const Vec lit = hn::Add(cosine, hn::Mul(hn::Set(f, light.softness), length));
  const Vec diffuse = hn::Mul(hn::Mul(hn::Set(f, light.diffuse), sum), hn::Max(lit, hn::Zero(f)));
  const Vec albedo = hn::Mul(hn::Set(f, 255), Dot(w, a.albedo, b.albedo, c.albedo));
  const Vec gray =
      hn::Div(hn::Mul(albedo, hn::Add(ambient, diffuse)), hn::Mul(hn::Mul(sum, sum), length));
  const Vec clipped = hn::Min(hn::Max(gray, hn::Zero(f)), hn::Set(f, 255));
  return hn::ConvertTo(Ints(), hn::Add(clipped, hn::Set(f, 0.5F)));
}

// The first of the pixels 0, 1, ..., size that is not left of `low`; size means none.
HWY_INLINE int FirstPixel(float low, int size) {
  const float inside = std::clamp(low, 0.0F, static_cast<float>(size));
  const int truncated = static_cast<int>(inside);
  return truncated + static_cast<int>(static_cast<float>(truncated) < inside);
}

// The last of the pixels -1, 0, ..., size - 1 that is not right of `high`; -1 means none.
HWY_INLINE int LastPixel(float high, int size) {
  return static_cast<int>(std::clamp(high + 1, 0.0F, static_cast<float>(size))) - 1;
}

// The pixels whose centres lie in a triangle's bounding box.
struct Candidate {
  std::uint32_t triangle;
  int left, top, right, bottom;
};

// The picture in the making, with a margin for tiles that stick out to the right or below.
class Canvas {
 public:
  Canvas(int width, int height)
      : width_(width),
        height_(height),
        stride_(static_cast<std::size_t>(width + kTileWidth - 1)),
        inverse_z_(stride_ * static_cast<std::size_t>(height + TileHeight())),
        pixels_(inverse_z_.size()) {}

  void Draw(const RasterSurface& surface, const HandLight& light,
            std::span<const std::uint32_t> triangles) {
    for (const Candidate& candidate : Candidates(surface, triangles)) {
      const auto [a, b, c] = surface.facets.triangles[candidate.triangle];
      const Corner corners[3] = {{surface.seen[a], surface.shading[a]},
                                 {surface.seen[b], surface.shading[b]},
                                 {surface.seen[c], surface.shading[c]}};
      for (int y = candidate.top; y <= candidate.bottom; y += TileHeight()) {
        for (int x = candidate.left; x <= candidate.right; x += kTileWidth) {
          DrawTile(corners, light, surface.label, x, y);
        }
      }
    }
  }

  void Copy(View& view) const {
    for (int y = 0; y < height_; ++y) {
      const std::int32_t* row = pixels_.data() + Place(0, y);
      std::uint8_t *shading = view.shading.row(y), *label = view.label.row(y);
      for (int x = 0; x < width_; ++x) {
        shading[x] = static_cast<std::uint8_t>(row[x]);
        label[x] = static_cast<std::uint8_t>(row[x] >> 8);
      }
    }
  }

 private:
  std::size_t Place(int x, int y) const {
    return static_cast<std::size_t>(y) * stride_ + static_cast<std::size_t>(x);
  }

  // Those triangles that may cover a pixel. Found for all of them before one is drawn: a loop that
  // had to wait for vertices to know how many tiles it draws would be guessed wrong too often, and
  // took twice the time.
  std::vector<Candidate> Candidates(const RasterSurface& surface,
                                    std::span<const std::uint32_t> triangles) const {
    std::vector<Candidate> candidates(triangles.size() + 1);
    std::size_t count = 0;
    for (const std::uint32_t triangle : triangles) {
      const auto [ia, ib, ic] = surface.facets.triangles[triangle];
      const ProjectedVertex &a = surface.seen[ia], &b = surface.seen[ib], &c = surface.seen[ic];
      const Candidate candidate = {triangle, FirstPixel(std::min({a.x, b.x, c.x}), width_),
                                   FirstPixel(std::min({a.y, b.y, c.y}), height_),
                                   LastPixel(std::max({a.x, b.x, c.x}), width_),
                                   LastPixel(std::max({a.y, b.y, c.y}), height_)};
      candidates[count] = candidate;
      count += static_cast<std::size_t>((candidate.left <= candidate.right) &
                                        (candidate.top <= candidate.bottom));
    }
    candidates.resize(count);
    return candidates;
  }

  HWY_INLINE void DrawTile(const Corner (&corners)[3], const HandLight& light, SurfaceLabel label,
                           int left, int top) {
    const Floats f;
    const Ints ints;
    const auto lane = hn::Iota(ints, 0);
    const Vec x = hn::Add(hn::ConvertTo(f, hn::And(lane, hn::Set(ints, kTileWidth - 1))),
                          hn::Set(f, static_cast<float>(left)));
    const Vec y =
        hn::Add(hn::ConvertTo(f, hn::ShiftRight<2>(lane)), hn::Set(f, static_cast<float>(top)));
    const Weights weights = WeightsAt(corners, x, y);
    const auto& w = weights.flat;
    const auto covered = hn::Ge(hn::Min(hn::Min(w[0], w[1]), w[2]), hn::Zero(f));
    const Vec inverse_z = hn::Div(Sum(weights.in_space), Sum(w));
    float* held_z = inverse_z_.data() + Place(left, top);
    const Vec before = LoadRows(f, held_z, stride_);
    const auto nearer = hn::And(covered, hn::Gt(inverse_z, before));
    if (hn::AllFalse(f, nearer)) return;
    StoreRows(f, hn::IfThenElse(nearer, inverse_z, before), held_z, stride_);
    std::int32_t* held = pixels_.data() + Place(left, top);
    const auto pixel = hn::Add(Gray(corners, weights, light), hn::Set(ints, label << 8));
    const auto blended =
        hn::IfThenElse(hn::RebindMask(ints, nearer), pixel, LoadRows(ints, held, stride_));
    StoreRows(ints, blended, held, stride_);
  }

  int width_, height_;
  std::size_t stride_;
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
    canvas.Draw(surface, light, FacingTriangles(surface.facets, eye));
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
