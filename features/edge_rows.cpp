// SPDX-License-Identifier: MIT
// Compiled once for each instruction set; the best one that the processor has is chosen when the
// program runs.
#include "edge_rows.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "edge_rows.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace graspdb {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, 16>;
using Vec = hn::Vec<Floats>;

HWY_INLINE Vec Number(float value) {
  return hn::Set(Floats(), value);
}

// A pixel's gradient, `across` the picture and `down`; as many pixels as a vector has lanes.
struct Gradient {
  Vec across, down;
};

HWY_INLINE Vec Smooth(Vec before, Vec at, Vec after) {
  return hn::Add(hn::Add(before, hn::Mul(Number(2), at)), after);
}

HWY_INLINE Gradient GradientAt(const float* HWY_RESTRICT pixel) {
  const auto at = [&](std::ptrdiff_t right, std::ptrdiff_t down) HWY_ATTR {
    return hn::LoadU(Floats(), pixel + down * static_cast<std::ptrdiff_t>(kEdgeStride) + right);
  };
  const Vec left = Smooth(at(-1, -1), at(-1, 0), at(-1, 1));
  const Vec right = Smooth(at(1, -1), at(1, 0), at(1, 1));
  const Vec top = Smooth(at(-1, -1), at(0, -1), at(1, -1));
  const Vec bottom = Smooth(at(-1, 1), at(0, 1), at(1, 1));
  return {hn::Div(hn::Sub(right, left), Number(8)), hn::Div(hn::Sub(bottom, top), Number(8))};
}

HWY_INLINE Vec Bin(const Gradient& g) {
  const Floats f;
  const Vec across = hn::Abs(g.across), down = hn::Abs(g.down), zero = hn::Zero(f);
  const Vec slope = hn::Div(hn::Min(across, down), hn::Max(across, down));
  // atan(slope) to 0.004 radians, in bins of pi / 8.
  const Vec bend = hn::Mul(Number(0.695F), hn::Sub(Number(1), slope));
  const Vec octant = hn::Mul(slope, hn::Add(Number(2), bend));
  const Vec quadrant = hn::IfThenElse(hn::Ge(across, down), octant, hn::Sub(Number(4), octant));
  const auto mirrored = hn::Xor(hn::Lt(g.across, zero), hn::Lt(g.down, zero));
  return hn::IfThenElse(mirrored, hn::Sub(Number(8), quadrant), quadrant);
}

HWY_INLINE Vec Length(const Gradient& g) {
  return hn::Sqrt(hn::Add(hn::Mul(g.across, g.across), hn::Mul(g.down, g.down)));
}

// The contrast of noise and of gentle shading does not count, and a shadow's no more than this.
// Chosen by retrieving views of another hand in other light.
HWY_INLINE Vec InnerWeight(Vec contrast) {
  constexpr float kFaint = 0.03F, kMost = 0.15F, kGain = 2;
  const Vec clear = hn::Sub(contrast, Number(kFaint));
  return hn::Mul(Number(kGain), hn::Min(hn::Max(clear, Number(0)), Number(kMost)));
}

// Of the nine pixels that a gradient looks at.
HWY_INLINE Vec LeastCoverage(const float* HWY_RESTRICT pixel) {
  const Floats f;
  Vec least = hn::LoadU(f, pixel);
  for (const float* row : {pixel - kEdgeStride, pixel, pixel + kEdgeStride}) {
    least = hn::Min(hn::Min(least, hn::LoadU(f, row)),
                    hn::Min(hn::LoadU(f, row - 1), hn::LoadU(f, row + 1)));
  }
  return least;
}

void FindEdges(const EdgeCanvas& coverage, const EdgeCanvas& brightness, std::size_t y,
               EdgeRow& edges) {
  const Floats f;
  for (std::size_t x = 0; x < kEdgeSide; x += hn::Lanes(f)) {
    const float* covered = coverage.data() + edge_index(x, y);
    const Gradient outline = GradientAt(covered);
    hn::StoreU(Bin(outline), f, edges.outline_bin.data() + x);
    hn::StoreU(Length(outline), f, edges.outline_weight.data() + x);
    const Gradient inner = GradientAt(brightness.data() + edge_index(x, y));
    const auto well_inside = hn::Gt(LeastCoverage(covered), Number(0.5F));
    hn::StoreU(Bin(inner), f, edges.inner_bin.data() + x);
    hn::StoreU(hn::IfThenElseZero(well_inside, InnerWeight(Length(inner))), f,
               edges.inner_weight.data() + x);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace graspdb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graspdb {

HWY_EXPORT(FindEdges);

void find_edges(const EdgeCanvas& coverage, const EdgeCanvas& brightness, std::size_t y,
                EdgeRow& edges) {
  HWY_DYNAMIC_DISPATCH(FindEdges)(coverage, brightness, y, edges);
}

}  // namespace graspdb
#endif
