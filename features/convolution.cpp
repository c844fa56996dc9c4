// SPDX-License-Identifier: MIT
// Compiled once for each instruction set; the best one that the processor has is chosen when the
// program runs.
#include "convolution.h"

// Instructions that multiply and add four bytes at once.
#define HWY_WANT_AVX3_DL

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "convolution.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace graspdb {
namespace HWY_NAMESPACE {
// Elsewhere ReorderWidenMulAccumulate spreads its sums over two results.
#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128 || !HWY_ARCH_X86

void ConvolveRow(const Convolution& layer, std::span<const std::uint8_t> picture, std::size_t y,
                 std::span<std::int32_t> row) {
  const std::size_t line = layer.padded_side() * layer.inputs;
  const std::size_t across = layer.kernel * layer.inputs;
  for (std::size_t x = 0; x < layer.out_side(); ++x) {
    const std::uint8_t* window =
        picture.data() + y * layer.stride * line + x * layer.stride * layer.inputs;
    for (std::size_t out = 0; out < layer.outputs; ++out) {
      const std::int8_t* weight = layer.weights.data() +
                                  out / kOutputBlock * layer.kernel * across * kOutputBlock +
                                  out % kOutputBlock * kInputQuad;
      std::int64_t sum = layer.bias[out];
      for (std::size_t i = 0; i < layer.kernel; ++i) {
        for (std::size_t j = 0; j < across; j += kInputQuad) {
          for (std::size_t k = 0; k < kInputQuad; ++k)
            sum += std::int64_t{window[i * line + j + k]} * weight[k];
          weight += kInputQuad * kOutputBlock;
        }
      }
      row[x * layer.outputs + out] =
          static_cast<std::int32_t>((sum * layer.multiplier[out] + (std::int64_t{1} << 31)) >> 32);
    }
  }
}

#else

namespace hn = hwy::HWY_NAMESPACE;

using Sums = hn::CappedTag<std::int32_t, kOutputBlock>;
using Bytes = hn::Repartition<std::int8_t, Sums>;
using Shorts = hn::Repartition<std::int16_t, Sums>;
using Longs = hn::Repartition<std::int64_t, Sums>;
using SumsVec = hn::Vec<Sums>;

// The upper halves of the products, rounded.
HWY_INLINE SumsVec Scaled(SumsVec sums, SumsVec multipliers) {
  const Sums s;
  const Longs l;
  const auto half = hn::Set(l, std::int64_t{1} << 31);
  const auto upper = [&](SumsVec v) HWY_ATTR {
    return hn::BitCast(s, hn::ShiftRight<32>(hn::BitCast(hn::RepartitionToWide<Sums>(), v)));
  };
  const auto even = hn::Add(hn::MulEven(sums, multipliers), half);
  const auto odd = hn::Add(hn::MulEven(upper(sums), upper(multipliers)), half);
  return hn::OddEven(hn::BitCast(s, odd), upper(hn::BitCast(s, even)));
}

// Four neighbouring inputs, as they lie, in every lane.
HWY_INLINE SumsVec QuadAt(const std::uint8_t* HWY_RESTRICT inputs) {
  std::int32_t quad = 0;
  std::memcpy(&quad, inputs, sizeof(quad));
  return hn::Set(Sums(), quad);
}

#if HWY_TARGET == HWY_AVX3_DL

using QuadWeights = SumsVec;

HWY_INLINE QuadWeights LoadWeights(const std::int8_t* HWY_RESTRICT weights) {
  return hn::BitCast(Sums(), hn::LoadU(Bytes(), weights));
}

HWY_INLINE SumsVec AddProducts(SumsVec sums, SumsVec inputs, const QuadWeights& weights) {
  // Highway lets its compilers use every instruction of this target but this one.
  asm("vpdpbusd %2, %1, %0" : "+v"(sums.raw) : "v"(inputs.raw), "v"(weights.raw));
  return sums;
}

#else

// The first and third of each four, the second and fourth, as words.
struct QuadWeights {
  hn::Vec<Shorts> even, odd;
};

HWY_INLINE QuadWeights LoadWeights(const std::int8_t* HWY_RESTRICT weights) {
  const auto all = hn::BitCast(Shorts(), hn::LoadU(Bytes(), weights));
  return {hn::ShiftRight<8>(hn::ShiftLeft<8>(all)), hn::ShiftRight<8>(all)};
}

HWY_INLINE SumsVec AddProducts(SumsVec sums, SumsVec inputs, const QuadWeights& weights) {
  const Shorts w;
  const hn::RebindToUnsigned<Shorts> u;
  const auto even = hn::And(hn::BitCast(w, inputs), hn::Set(w, 255));
  const auto odd = hn::BitCast(w, hn::ShiftRight<8>(hn::BitCast(u, inputs)));
  SumsVec none = hn::Zero(Sums());
  sums = hn::ReorderWidenMulAccumulate(Sums(), even, weights.even, sums, none);
  return hn::ReorderWidenMulAccumulate(Sums(), odd, weights.odd, sums, none);
}

#endif

// kPixels neighbours of the result, for kVectors times as many outputs as a vector has lanes.
template <std::size_t kVectors, std::size_t kPixels>
HWY_INLINE void ConvolvePixels(const Convolution& layer, const std::uint8_t* HWY_RESTRICT window,
                               std::size_t out, std::int32_t* HWY_RESTRICT row) {
  const Sums s;
  const std::size_t line = layer.padded_side() * layer.inputs;
  const std::size_t across = layer.kernel * layer.inputs, step = layer.stride * layer.inputs;
  std::array<const std::int8_t*, kVectors> weight;
  std::array<std::array<SumsVec, kPixels>, kVectors> sums;
  for (std::size_t v = 0; v < kVectors; ++v) {
    const std::size_t first = out + v * hn::Lanes(s);
    weight[v] = layer.weights.data() + first / kOutputBlock * layer.kernel * across * kOutputBlock +
                first % kOutputBlock * kInputQuad;
    sums[v].fill(hn::LoadU(s, layer.bias.data() + first));
  }
  for (std::size_t i = 0; i < layer.kernel; ++i) {
    for (std::size_t j = 0; j < across; j += kInputQuad) {
      std::array<SumsVec, kPixels> inputs;
      for (std::size_t pixel = 0; pixel < kPixels; ++pixel)
        inputs[pixel] = QuadAt(window + i * line + j + pixel * step);
      for (std::size_t v = 0; v < kVectors; ++v) {
        const QuadWeights weights = LoadWeights(weight[v]);
        for (std::size_t pixel = 0; pixel < kPixels; ++pixel)
          sums[v][pixel] = AddProducts(sums[v][pixel], inputs[pixel], weights);
        weight[v] += kInputQuad * kOutputBlock;
      }
    }
  }
  for (std::size_t v = 0; v < kVectors; ++v) {
    const std::size_t first = out + v * hn::Lanes(s);
    const SumsVec multipliers = hn::LoadU(s, layer.multiplier.data() + first);
    for (std::size_t pixel = 0; pixel < kPixels; ++pixel)
      hn::StoreU(Scaled(sums[v][pixel], multipliers), s, row + pixel * layer.outputs + first);
  }
}

template <std::size_t kVectors>
HWY_INLINE void ConvolveOutputs(const Convolution& layer, const std::uint8_t* HWY_RESTRICT start,
                                std::size_t out, std::int32_t* HWY_RESTRICT row) {
  constexpr std::size_t kMany = 4;  // pixels that share each load of weights
  const std::size_t step = layer.stride * layer.inputs, width = layer.out_side();
  std::size_t x = 0;
  for (; x + kMany <= width; x += kMany)
    ConvolvePixels<kVectors, kMany>(layer, start + x * step, out, row + x * layer.outputs);
  for (; x < width; ++x)
    ConvolvePixels<kVectors, 1>(layer, start + x * step, out, row + x * layer.outputs);
}

void ConvolveRow(const Convolution& layer, std::span<const std::uint8_t> picture, std::size_t y,
                 std::span<std::int32_t> row) {
  const std::uint8_t* start =
      picture.data() + y * layer.stride * layer.padded_side() * layer.inputs;
  const std::size_t lanes = hn::Lanes(Sums());
  std::size_t out = 0;
  for (; out + 2 * lanes <= layer.outputs; out += 2 * lanes)
    ConvolveOutputs<2>(layer, start, out, row.data());
  for (; out < layer.outputs; out += lanes) ConvolveOutputs<1>(layer, start, out, row.data());
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace graspdb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graspdb {

HWY_EXPORT(ConvolveRow);

void convolve_row(const Convolution& layer, std::span<const std::uint8_t> picture, std::size_t y,
                  std::span<std::int32_t> row) {
  HWY_DYNAMIC_DISPATCH(ConvolveRow)(layer, picture, y, row);
}

}  // namespace graspdb
#endif
