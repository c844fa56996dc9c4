// SPDX-License-Identifier: MIT
// Files of weights as a trainer would write them, with drawn numbers.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "graspdb/core/json/safetensors.h"
#include "graspdb/core/random.h"

namespace graspdb::testing {

struct NetLayer {
  std::size_t outputs, kernel, inputs;
  int stride, padding;
  std::vector<std::int8_t> weights;  // [outputs][kernel][kernel][inputs]
  std::vector<std::int32_t> bias, multiplier;
  std::optional<std::size_t> beside = {};  // of a finder
};

// Sums become about as large as a byte.
inline NetLayer random_layer(std::size_t outputs, std::size_t kernel, std::size_t inputs,
                             int stride, int padding, RandomStream& random) {
  NetLayer layer{outputs, kernel, inputs, stride, padding, {}, {}, {}, {}};
  const std::size_t products = kernel * kernel * inputs;
  for (std::size_t i = 0; i < outputs * products; ++i) {
    layer.weights.push_back(static_cast<std::int8_t>(static_cast<int>(random.below(256)) - 128));
  }
  for (std::size_t i = 0; i < outputs; ++i) {
    layer.bias.push_back(static_cast<std::int32_t>(random.below(20000)) - 10000);
    layer.multiplier.push_back(static_cast<std::int32_t>(
        random.uniform(0.5, 2) * 4294967296.0 / (74 * std::sqrt(static_cast<double>(products)))));
  }
  return layer;
}

struct NetFile {
  std::vector<NetLayer> layers;
  std::map<std::string, std::string> metadata = {{"format", "graspdb descriptor"},
                                                 {"format_version", "2"},
                                                 {"planes", R"(["gray","mask"])"},
                                                 {"embedding_scale", "500"}};

  std::string bytes() const {
    std::vector<TensorInfo> tensors;
    std::string data;
    nlohmann::json table = nlohmann::json::array();
    const auto add = [&]<typename T>(const std::string& name, const char* dtype,
                                     std::vector<std::size_t> shape,
                                     const std::vector<T>& numbers) {
      tensors.push_back({name, dtype, std::move(shape)});
      data.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T));
    };
    for (std::size_t i = 0; i < layers.size(); ++i) {
      const NetLayer& layer = layers[i];
      const std::string name = "layer" + std::to_string(i);
      add(name + ".weight", "I8", {layer.outputs, layer.kernel, layer.kernel, layer.inputs},
          layer.weights);
      add(name + ".bias", "I32", {layer.outputs}, layer.bias);
      add(name + ".multiplier", "I32", {layer.outputs}, layer.multiplier);
      table.push_back({{"stride", layer.stride}, {"padding", layer.padding}});
      if (layer.beside) table.back()["beside"] = *layer.beside;
    }
    auto all = metadata;
    all.insert({"layers", table.dump()});
    return safetensors_header(tensors, all) + data;
  }
};

// Odd numbers of channels, and a picture that the strides do not divide.
inline NetFile small_net(std::uint64_t seed) {
  RandomStream random(seed);
  NetFile file;
  file.layers = {random_layer(9, 5, 2, 3, 1, random), random_layer(20, 3, 9, 2, 1, random),
                 random_layer(64, 11, 20, 1, 0, random)};
  return file;
}

inline NetFile finder_file(std::vector<NetLayer> layers) {
  return {std::move(layers),
          {{"format", "graspdb finder"},
           {"format_version", "1"},
           {"score_step", "0.0625"},
           {"parts", R"(["rest", "hand", "arm", "object"])"}}};
}

// Down to a quarter and up to half of the size, with odd numbers of channels.
inline NetFile small_finder(std::uint64_t seed) {
  RandomStream random(seed);
  NetFile file =
      finder_file({random_layer(5, 5, 3, 2, 2, random), random_layer(9, 3, 5, 2, 1, random),
                   random_layer(7, 3, 9 + 5, 1, 1, random), random_layer(4, 1, 7, 1, 0, random)});
  file.layers[2].beside = 0;
  return file;
}

}  // namespace graspdb::testing
