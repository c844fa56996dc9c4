// SPDX-License-Identifier: MIT
// A layer as docs/descriptors.md states it, number by number.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "features/net_bytes.h"

namespace graspdb::testing {

struct Cube {
  std::size_t width, height, channels;
  std::vector<std::int64_t> values;
  // 0 beyond the border.
  std::int64_t at(std::ptrdiff_t x, std::ptrdiff_t y, std::size_t channel) const {
    if (x < 0 || y < 0 || x >= static_cast<std::ptrdiff_t>(width) ||
        y >= static_cast<std::ptrdiff_t>(height))
      return 0;
    return values[(static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)) * channels +
                  channel];
  }
};

inline std::int64_t product_sum(const NetLayer& layer, const Cube& in, std::size_t out,
                                std::ptrdiff_t x, std::ptrdiff_t y) {
  std::int64_t sum = layer.bias[out];
  std::size_t weight = out * layer.kernel * layer.kernel * layer.inputs;
  for (std::size_t i = 0; i < layer.kernel; ++i) {
    for (std::size_t j = 0; j < layer.kernel; ++j) {
      for (std::size_t c = 0; c < layer.inputs; ++c) {
        sum += layer.weights[weight++] *
               in.at(x + static_cast<std::ptrdiff_t>(j), y + static_cast<std::ptrdiff_t>(i), c);
      }
    }
  }
  return sum;
}

inline Cube plain_layer(const NetLayer& layer, const Cube& in, bool is_last) {
  const auto size = [&](std::size_t before) {
    return (before + 2 * static_cast<std::size_t>(layer.padding) - layer.kernel) /
               static_cast<std::size_t>(layer.stride) +
           1;
  };
  Cube result{size(in.width), size(in.height), layer.outputs, {}};
  for (std::ptrdiff_t y = 0; y < static_cast<std::ptrdiff_t>(result.height); ++y) {
    for (std::ptrdiff_t x = 0; x < static_cast<std::ptrdiff_t>(result.width); ++x) {
      for (std::size_t out = 0; out < layer.outputs; ++out) {
        const std::int64_t sum = product_sum(layer, in, out, x * layer.stride - layer.padding,
                                             y * layer.stride - layer.padding);
        const auto value = static_cast<std::int64_t>(std::floor(
            (static_cast<long double>(sum) * layer.multiplier[out]) / 4294967296.0L + 0.5L));
        result.values.push_back(is_last ? value : std::clamp<std::int64_t>(value, 0, 255));
      }
    }
  }
  return result;
}

// The coarse one's pixels four times, and beside them the fine one's.
inline Cube plain_join(const Cube& coarse, const Cube& fine) {
  Cube result{fine.width, fine.height, coarse.channels + fine.channels, {}};
  for (std::ptrdiff_t y = 0; y < static_cast<std::ptrdiff_t>(fine.height); ++y) {
    for (std::ptrdiff_t x = 0; x < static_cast<std::ptrdiff_t>(fine.width); ++x) {
      for (std::size_t c = 0; c < coarse.channels; ++c)
        result.values.push_back(coarse.at(x / 2, y / 2, c));
      for (std::size_t c = 0; c < fine.channels; ++c) result.values.push_back(fine.at(x, y, c));
    }
  }
  return result;
}

}  // namespace graspdb::testing
