// SPDX-License-Identifier: MIT
#include "layer_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "graspdb/core/error.h"
#include "graspdb/core/json/strict_json.h"
#include "graspdb/core/rounded_up.h"

namespace graspdb {
namespace {

constexpr std::size_t kMostChannels = 1024;
constexpr std::int64_t kLargestInput = 255;
constexpr std::int64_t kMostResult = std::int64_t{1} << 27;

// What a layer's tensors say of it, as they lie in the file.
struct LayerTensors {
  std::string name;
  std::size_t outputs, kernel, inputs;
  std::vector<std::int8_t> weights;  // [outputs][kernel][kernel][inputs]
  std::vector<std::int32_t> bias, multiplier;
};

LayerTensors read_tensors(const Safetensors& file, std::size_t number) {
  LayerTensors tensors{};
  tensors.name = fmt::format("layer{}", number);
  const std::string weight = tensors.name + ".weight";
  tensors.weights = file.tensor<std::int8_t>({weight, "I8", {0, 0, 0, 0}});
  const std::vector<std::size_t>& shape = file.shape(weight);
  if (shape[1] != shape[2] || shape[1] > kLargestKernel ||
      std::max(shape[0], shape[3]) > kMostChannels) {
    throw Error({file.file(), weight,
                 fmt::format("a square kernel and up to {} channels", kMostChannels),
                 fmt::format("[{}]", fmt::join(shape, ", "))});
  }
  tensors.outputs = shape[0];
  tensors.kernel = shape[1];
  tensors.inputs = shape[3];
  tensors.bias = file.tensor<std::int32_t>({tensors.name + ".bias", "I32", {tensors.outputs}});
  tensors.multiplier =
      file.tensor<std::int32_t>({tensors.name + ".multiplier", "I32", {tensors.outputs}});
  return tensors;
}

std::int64_t largest_sum(const LayerTensors& tensors, std::size_t out) {
  const std::size_t products = tensors.weights.size() / tensors.outputs;
  std::int64_t largest = std::abs(std::int64_t{tensors.bias[out]});
  for (std::size_t i = 0; i < products; ++i) {
    largest += kLargestInput * std::abs(int{tensors.weights[out * products + i]});
  }
  return largest;
}

// Nothing that comes in may make a sum of 32 bits overflow.
void check_sums(const LayerTensors& tensors, const std::string& file) {
  for (std::size_t out = 0; out < tensors.outputs; ++out) {
    const std::int64_t largest = largest_sum(tensors, out);
    if (largest > std::numeric_limits<std::int32_t>::max()) {
      throw Error({file, tensors.name + ".bias", "sums below 2^31", fmt::format("{}", largest)});
    }
    if (tensors.multiplier[out] < 0) {
      throw Error({file, tensors.name + ".multiplier", "0 or more",
                   fmt::format("{}", tensors.multiplier[out])});
    }
  }
}

// Nor what is worked out from the last layer's results, in 64 bits.
void check_results(const LayerTensors& tensors, const std::string& file) {
  for (std::size_t out = 0; out < tensors.outputs; ++out) {
    const std::int64_t largest = largest_sum(tensors, out) * tensors.multiplier[out] >> 32;
    if (largest < kMostResult) continue;
    throw Error({file, tensors.name + ".multiplier", "results below 2^27 at the end",
                 fmt::format("{}", largest)});
  }
}

// Where each channel of the file lies in the picture.
std::vector<std::size_t> places_of(const std::vector<Channels>& inputs) {
  std::vector<std::size_t> places;
  std::size_t begin = 0;
  for (const Channels& channels : inputs) {
    for (std::size_t i = 0; i < channels.count; ++i) places.push_back(begin + i);
    begin += channels.stored;
  }
  return places;
}

// In the order of Convolution::weights.
std::vector<std::int8_t> packed(const LayerTensors& tensors, const Convolution& layer,
                                const std::vector<std::size_t>& channel_places) {
  const std::size_t places = layer.kernel * layer.kernel;
  const std::size_t block = places * layer.inputs * kOutputBlock;
  std::vector<std::int8_t> result(layer.outputs / kOutputBlock * block);
  for (std::size_t i = 0; i < tensors.weights.size(); ++i) {
    const std::size_t in = channel_places[i % tensors.inputs];
    const std::size_t place = i / tensors.inputs % places, out = i / tensors.inputs / places;
    const std::size_t input = place * layer.inputs + in;
    result[out / kOutputBlock * block + input / kInputQuad * kInputQuad * kOutputBlock +
           out % kOutputBlock * kInputQuad + input % kInputQuad] = tensors.weights[i];
  }
  return result;
}

Convolution make_layer(LayerTensors tensors, const LayerPlace& place,
                       const std::vector<Channels>& inputs) {
  Convolution layer{.outputs = rounded_up(tensors.outputs, kOutputBlock),
                    .kernel = tensors.kernel,
                    .stride = place.stride,
                    .padding = place.padding};
  for (const Channels& channels : inputs) layer.inputs += channels.stored;
  layer.weights = packed(tensors, layer, places_of(inputs));
  layer.bias = std::move(tensors.bias);
  layer.multiplier = std::move(tensors.multiplier);
  layer.bias.resize(layer.outputs);
  layer.multiplier.resize(layer.outputs);
  return layer;
}

}  // namespace

Channels channels_of(std::size_t outputs) {
  return {outputs, rounded_up(outputs, kOutputBlock)};
}

ReadLayer read_layer(const Safetensors& file, const LayerPlace& place,
                     const std::vector<Channels>& inputs) {
  LayerTensors tensors = read_tensors(file, place.number);
  std::size_t count = 0;
  for (const Channels& channels : inputs) count += channels.count;
  if (tensors.inputs != count)
    refuse(file, tensors.name + ".weight", fmt::format("{} inputs", count), tensors.inputs);
  check_sums(tensors, file.file());
  if (place.is_last) check_results(tensors, file.file());
  const std::size_t outputs = tensors.outputs;
  return {make_layer(std::move(tensors), place, inputs), outputs};
}

void refuse(const Safetensors& file, const std::string& key, const std::string& expected,
            std::size_t found) {
  throw Error({file.file(), key, expected, fmt::format("{}", found)});
}

void expect_metadata(const Safetensors& file, const std::string& key, const std::string& expected) {
  const std::string& found = file.metadata(key);
  if (found != expected) throw Error({file.file(), key, expected, found});
}

nlohmann::json metadata_list(const Safetensors& file, const std::string& key, std::size_t most) {
  nlohmann::json value = parse_strict_json(file.metadata(key), file.file(), key);
  if (!value.is_array() || value.empty() || value.size() > most) {
    throw Error({file.file(), key, fmt::format("a list of 1 to {}", most), file.metadata(key)});
  }
  return value;
}

void expect_no_more_tensors(const Safetensors& file, std::size_t layers) {
  if (file.tensor_count() != 3 * layers)
    refuse(file, "layers", "three tensors a layer and no others", file.tensor_count());
}

}  // namespace graspdb
