// SPDX-License-Identifier: MIT
// Compiled once for each instruction set; the best one that the processor has is chosen when the
// program runs.
#include "convolution.h"

#define HWY_WANT_AVX3_DL

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "convolution.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h.
#include <hwy/highway.h>

#include <algorithm>
#include <array>

#include "graspdb/core/highway/byte_quads-inl.h"

HWY_BEFORE_NAMESPACE();
namespace graspdb {
namespace HWY_NAMESPACE {
#if !GRASPDB_HAS_BYTE_QUADS

void ConvolveRow(const Convolution& layer, const PaddedPicture& picture, std::size_t y,
                 std::span<std::int32_t> row) {
  const std::size_t line = picture.line();
  const std::size_t across = layer.kernel * layer.inputs;
  for (std::size_t x = 0; x < layer.out_size(picture.width); ++x) {
    const std::uint8_t* window =
        picture.bytes.data() + y * layer.stride * line + x * layer.stride * layer.inputs;
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

using Sums = QuadSums;
using Longs = hn::Repartition<std::int64_t, Sums>;
using SumsVec = QuadSumsVec;
static_assert(kOutputBlock % kByteQuadLanes == 0);

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

// kPixels neighbours of the result, for kVectors times as many outputs as a vector has lanes.
template <std::size_t kVectors, std::size_t kPixels>
HWY_INLINE void ConvolvePixels(const Convolution& layer, const std::uint8_t* HWY_RESTRICT window,
                               std::size_t line, std::size_t out, std::int32_t* HWY_RESTRICT row) {
  const Sums s;
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
        const SignedQuads weights = LoadSignedQuads(weight[v]);
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
HWY_INLINE void ConvolveOutputs(const Convolution& layer, const PaddedPicture& picture,
                                std::size_t y, std::size_t out, std::int32_t* HWY_RESTRICT row) {
  constexpr std::size_t kMany = 4;  // pixels that share each load of weights
  const std::size_t line = picture.line(), width = layer.out_size(picture.width);
  const std::size_t step = layer.stride * layer.inputs;
  const std::uint8_t* start = picture.bytes.data() + y * layer.stride * line;
  std::size_t x = 0;
  for (; x + kMany <= width; x += kMany)
    ConvolvePixels<kVectors, kMany>(layer, start + x * step, line, out, row + x * layer.outputs);
  for (; x < width; ++x)
    ConvolvePixels<kVectors, 1>(layer, start + x * step, line, out, row + x * layer.outputs);
}

void ConvolveRow(const Convolution& layer, const PaddedPicture& picture, std::size_t y,
                 std::span<std::int32_t> row) {
  const std::size_t lanes = hn::Lanes(Sums());
  std::size_t out = 0;
  for (; out + 2 * lanes <= layer.outputs; out += 2 * lanes)
    ConvolveOutputs<2>(layer, picture, y, out, row.data());
  for (; out < layer.outputs; out += lanes) ConvolveOutputs<1>(layer, picture, y, out, row.data());
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace graspdb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graspdb {

HWY_EXPORT(ConvolveRow);

void convolve_row(const Convolution& layer, const PaddedPicture& picture, std::size_t y,
                  std::span<std::int32_t> row) {
  HWY_DYNAMIC_DISPATCH(ConvolveRow)(layer, picture, y, row);
}

PaddedPicture convolve(const Convolution& layer, const PaddedPicture& picture,
                       std::size_t next_padding) {
  PaddedPicture result(layer.out_size(picture.width), layer.out_size(picture.height), layer.outputs,
                       next_padding);
  std::vector<std::int32_t> row(result.width * layer.outputs);
  for (std::size_t y = 0; y < result.height; ++y) {
    convolve_row(layer, picture, y, row);
    std::ranges::transform(row, result.row(y), [](std::int32_t value) {
      return static_cast<std::uint8_t>(std::clamp(value, 0, 255));
    });
  }
  return result;
}

}  // namespace graspdb
#endif
