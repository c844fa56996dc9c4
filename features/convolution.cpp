// SPDX-License-Identifier: MIT
// Compiled once for each instruction set; the best one that the processor has is chosen when the
// program runs.
#include "convolution.h"

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
namespace hn = hwy::HWY_NAMESPACE;

// Two neighbouring inputs, as they lie.
HWY_INLINE std::int32_t PairAt(const std::int16_t* HWY_RESTRICT inputs) {
  std::int32_t pair = 0;
  std::memcpy(&pair, inputs, sizeof(pair));
  return pair;
}

#if HWY_TARGET == HWY_SCALAR

void ConvolveRow(const Convolution& layer, std::span<const std::int16_t> picture, std::size_t y,
                 std::span<std::int32_t> row) {
  const std::size_t line = layer.padded_side() * layer.inputs;
  const std::size_t across = layer.kernel * layer.inputs;
  for (std::size_t x = 0; x < layer.out_side(); ++x) {
    const std::int16_t* window =
        picture.data() + y * layer.stride * line + x * layer.stride * layer.inputs;
    for (std::size_t out = 0; out < layer.outputs; ++out) {
      const std::int16_t* weight = layer.weights.data() +
                                   out / kOutputBlock * layer.kernel * across * kOutputBlock +
                                   out % kOutputBlock * kInputPair;
      std::int64_t sum = layer.bias[out];
      for (std::size_t i = 0; i < layer.kernel; ++i) {
        for (std::size_t j = 0; j < across; j += kInputPair) {
          const std::int16_t* input = window + i * line + j;
          sum += input[0] * weight[0] + input[1] * weight[1];
          weight += kInputPair * kOutputBlock;
        }
      }
      row[x * layer.outputs + out] =
          static_cast<std::int32_t>((sum * layer.multiplier[out] + (std::int64_t{1} << 31)) >> 32);
    }
  }
}

#else

using Sums = hn::CappedTag<std::int32_t, kOutputBlock>;
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

// kPixels neighbours of the result, for as many outputs as a vector has lanes.
template <std::size_t kPixels>
HWY_INLINE void ConvolvePixels(const Convolution& layer, const std::int16_t* HWY_RESTRICT window,
                               std::size_t out, std::int32_t* HWY_RESTRICT row) {
  const Sums s;
  const std::size_t line = layer.padded_side() * layer.inputs;
  const std::size_t across = layer.kernel * layer.inputs, step = layer.stride * layer.inputs;
  const std::int16_t* HWY_RESTRICT weight =
      layer.weights.data() + out / kOutputBlock * layer.kernel * across * kOutputBlock +
      out % kOutputBlock * kInputPair;
  std::array<SumsVec, kPixels> sums;
  for (SumsVec& sum : sums) sum = hn::LoadU(s, layer.bias.data() + out);
  SumsVec none = hn::Zero(s);
  for (std::size_t i = 0; i < layer.kernel; ++i) {
    for (std::size_t j = 0; j < across; j += kInputPair) {
      const auto weights = hn::LoadU(Shorts(), weight);
      for (std::size_t pixel = 0; pixel < kPixels; ++pixel) {
        const auto pair = hn::Set(s, PairAt(window + i * line + j + pixel * step));
        sums[pixel] = hn::ReorderWidenMulAccumulate(s, hn::BitCast(Shorts(), pair), weights,
                                                    sums[pixel], none);
      }
      weight += kInputPair * kOutputBlock;
    }
  }
  const SumsVec multipliers = hn::LoadU(s, layer.multiplier.data() + out);
  for (std::size_t pixel = 0; pixel < kPixels; ++pixel) {
    hn::StoreU(Scaled(sums[pixel], multipliers), s, row + pixel * layer.outputs + out);
  }
}

void ConvolveRow(const Convolution& layer, std::span<const std::int16_t> picture, std::size_t y,
                 std::span<std::int32_t> row) {
  constexpr std::size_t kMany = 8, kSome = 4;  // pixels that share each load of weights
  const std::size_t step = layer.stride * layer.inputs, width = layer.out_side();
  const std::int16_t* start =
      picture.data() + y * layer.stride * layer.padded_side() * layer.inputs;
  for (std::size_t out = 0; out < layer.outputs; out += hn::Lanes(Sums())) {
    std::size_t x = 0;
    for (; x + kMany <= width; x += kMany) {
      ConvolvePixels<kMany>(layer, start + x * step, out, row.data() + x * layer.outputs);
    }
    for (; x + kSome <= width; x += kSome) {
      ConvolvePixels<kSome>(layer, start + x * step, out, row.data() + x * layer.outputs);
    }
    for (; x < width; ++x) {
      ConvolvePixels<1>(layer, start + x * step, out, row.data() + x * layer.outputs);
    }
  }
}

#endif

}  // namespace HWY_NAMESPACE
}  // namespace graspdb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace graspdb {

HWY_EXPORT(ConvolveRow);

void convolve_row(const Convolution& layer, std::span<const std::int16_t> picture, std::size_t y,
                  std::span<std::int32_t> row) {
  HWY_DYNAMIC_DISPATCH(ConvolveRow)(layer, picture, y, row);
}

}  // namespace graspdb
#endif
