// SPDX-License-Identifier: MIT
// Layers as all files of weights have them: tensors layerN.weight, .bias and .multiplier
// (docs/descriptors.md).
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "convolution.h"
#include "graspdb/core/json/safetensors.h"

namespace graspdb {

constexpr std::size_t kMostFileBytes = std::size_t{16} << 20;  // far above what a small net needs
constexpr std::size_t kMostLayers = 32, kLargestKernel = 64;

// Channels of a picture that a layer reads. `stored` lie side by side, zeros after the first ones.
struct Channels {
  std::size_t count = 0, stored = 0;
};

// Of the picture that a layer with so many outputs gives.
Channels channels_of(std::size_t outputs);

struct LayerPlace {
  std::size_t number = 0, stride = 1, padding = 0;
  bool is_last = false;  // its results are not cut to a byte
};

struct ReadLayer {
  Convolution convolution;
  std::size_t outputs = 0;  // without those of weight 0
};

// Of a layer that reads these pictures, one's channels after the other's. Throws Error for tensors
// that are not there or do not fit, for sums that can exceed 32 bits, and for results at the end
// of 2^27 or more.
ReadLayer read_layer(const Safetensors& file, const LayerPlace& place,
                     const std::vector<Channels>& inputs);

[[noreturn]] void refuse(const Safetensors& file, const std::string& key,
                         const std::string& expected, std::size_t found);
// Throws Error unless the metadata has this value.
void expect_metadata(const Safetensors& file, const std::string& key, const std::string& expected);
// A list of 1 to `most` values.
nlohmann::json metadata_list(const Safetensors& file, const std::string& key, std::size_t most);
// Throws Error for a file with tensors other than those of its layers.
void expect_no_more_tensors(const Safetensors& file, std::size_t layers);

}  // namespace graspdb
