// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "graspdb/core/descriptor.h"
#include "graspdb/core/error.h"
#include "graspdb/core/hash.h"
#include "graspdb/core/json/safetensors.h"
#include "graspdb/core/json/strict_json.h"
#include "graspdb/core/rounded_up.h"
#include "net.h"

namespace graspdb {
namespace {

using nlohmann::json;

constexpr std::size_t kMostFileBytes = std::size_t{16} << 20;  // far above what a small net needs
constexpr const char* kFormat = "graspdb descriptor";
constexpr const char* kFormatVersion = "2";
constexpr int kMostLayers = 32, kMostChannels = 1024, kMostScale = 4096;
constexpr std::int64_t kLargestInput = 255;
constexpr std::int64_t kMostResult = std::int64_t{1} << 27;

void expect(const Safetensors& file, const std::string& key, const std::string& expected) {
  const std::string& found = file.metadata(key);
  if (found != expected) throw Error({file.file(), key, expected, found});
}

json list(const Safetensors& file, const std::string& key, std::size_t most) {
  json value = parse_strict_json(file.metadata(key), file.file(), key);
  if (!value.is_array() || value.empty() || value.size() > most) {
    throw Error({file.file(), key, fmt::format("a list of 1 to {}", most), file.metadata(key)});
  }
  return value;
}

std::vector<CropPlane HandCrop::*> read_planes(const Safetensors& file) {
  constexpr std::pair<const char*, CropPlane HandCrop::*> kPlanes[] = {
      {"gray", &HandCrop::gray}, {"mask", &HandCrop::mask}, {"scene", &HandCrop::scene}};
  std::vector<CropPlane HandCrop::*> planes;
  for (const json& name : list(file, "planes", std::size(kPlanes))) {
    const auto* known = std::ranges::find_if(
        kPlanes, [&](const auto& plane) { return name.is_string() && name == plane.first; });
    if (known == std::end(kPlanes)) {
      throw Error({file.file(), "planes", "gray, mask or scene", name.dump()});
    }
    planes.push_back(known->second);
  }
  return planes;
}

// What a layer's tensors say of it, as they lie in the file.
struct LayerTensors {
  std::size_t outputs, kernel, inputs;
  std::vector<std::int8_t> weights;  // [outputs][kernel][kernel][inputs]
  std::vector<std::int32_t> bias, multiplier;
};

LayerTensors read_tensors(const Safetensors& file, std::size_t number) {
  const std::string name = fmt::format("layer{}", number);
  const std::string weight = name + ".weight";
  LayerTensors tensors{};
  tensors.weights = file.tensor<std::int8_t>({weight, "I8", {0, 0, 0, 0}});
  const std::vector<std::size_t>& shape = file.shape(weight);
  if (shape[1] != shape[2] || shape[1] > kCropSide ||
      std::max(shape[0], shape[3]) > kMostChannels) {
    throw Error({file.file(), weight,
                 fmt::format("a square kernel and up to {} channels", kMostChannels),
                 fmt::format("[{}]", fmt::join(shape, ", "))});
  }
  tensors.outputs = shape[0];
  tensors.kernel = shape[1];
  tensors.inputs = shape[3];
  tensors.bias = file.tensor<std::int32_t>({name + ".bias", "I32", {tensors.outputs}});
  tensors.multiplier = file.tensor<std::int32_t>({name + ".multiplier", "I32", {tensors.outputs}});
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
void check_sums(const LayerTensors& tensors, const std::string& name, const std::string& file) {
  for (std::size_t out = 0; out < tensors.outputs; ++out) {
    const std::int64_t largest = largest_sum(tensors, out);
    if (largest > std::numeric_limits<std::int32_t>::max()) {
      throw Error({file, name + ".bias", "sums below 2^31", fmt::format("{}", largest)});
    }
    if (tensors.multiplier[out] < 0) {
      throw Error(
          {file, name + ".multiplier", "0 or more", fmt::format("{}", tensors.multiplier[out])});
    }
  }
}

// Nor a sum of squares of the last layer's results, of 64 bits.
void check_results(const LayerTensors& tensors, const std::string& name, const std::string& file) {
  for (std::size_t out = 0; out < tensors.outputs; ++out) {
    const std::int64_t largest = largest_sum(tensors, out) * tensors.multiplier[out] >> 32;
    if (largest < kMostResult) continue;
    throw Error(
        {file, name + ".multiplier", "results below 2^27 at the end", fmt::format("{}", largest)});
  }
}

// In the order of Convolution::weights.
std::vector<std::int8_t> packed(const LayerTensors& tensors, const Convolution& layer) {
  const std::size_t places = layer.kernel * layer.kernel;
  const std::size_t block = places * layer.inputs * kOutputBlock;
  std::vector<std::int8_t> result(layer.outputs / kOutputBlock * block);
  for (std::size_t i = 0; i < tensors.weights.size(); ++i) {
    const std::size_t in = i % tensors.inputs, place = i / tensors.inputs % places;
    const std::size_t out = i / tensors.inputs / places;
    const std::size_t input = place * layer.inputs + in;
    result[out / kOutputBlock * block + input / kInputQuad * kInputQuad * kOutputBlock +
           out % kOutputBlock * kInputQuad + input % kInputQuad] = tensors.weights[i];
  }
  return result;
}

Convolution make_layer(LayerTensors tensors, std::size_t stride, std::size_t padding,
                       std::size_t side, std::size_t inputs) {
  Convolution layer{.inputs = inputs,
                    .outputs = rounded_up(tensors.outputs, kOutputBlock),
                    .kernel = tensors.kernel,
                    .stride = stride,
                    .padding = padding,
                    .side = side};
  layer.weights = packed(tensors, layer);
  layer.bias = std::move(tensors.bias);
  layer.multiplier = std::move(tensors.multiplier);
  layer.bias.resize(layer.outputs);
  layer.multiplier.resize(layer.outputs);
  return layer;
}

// Reads layers one after the other, each for what the one before gives.
class NetReader {
 public:
  explicit NetReader(const Safetensors& file) : file_(file) {}

  Net read() {
    expect(file_, "format", kFormat);
    expect(file_, "format_version", kFormatVersion);
    net_.planes = read_planes(file_);
    channels_ = net_.planes.size();
    const json layers = list(file_, "layers", kMostLayers);
    for (const json& entry : layers) {
      add(JsonFields(entry, file_.file(), "layers"), &entry == &layers.back());
    }
    if (file_.tensor_count() != 3 * layers.size()) {
      refuse("layers", "three tensors a layer and no others", file_.tensor_count());
    }
    if (side_ != 1) refuse("layers", "one pixel at the end", side_);
    if (!is_embedding_size(channels_)) {
      refuse("layers", "64 or 128 outputs at the end", channels_);
    }
    net_.size = channels_;
    net_.scale = read_scale();
    return std::move(net_);
  }

 private:
  [[noreturn]] void refuse(const std::string& key, const std::string& expected,
                           std::size_t found) const {
    throw Error({file_.file(), key, expected, fmt::format("{}", found)});
  }

  int read_scale() const {
    const std::string key = "embedding_scale";
    const json fields{{key, parse_strict_json(file_.metadata(key), file_.file(), key)}};
    return JsonFields(fields, file_.file(), "").integer(key, 1, kMostScale);
  }

  void add(const JsonFields& entry, bool is_last) {
    const std::string name = fmt::format("layer{}", net_.layers.size());
    const auto stride = static_cast<std::size_t>(entry.integer("stride", 1, kCropSide));
    const auto padding = static_cast<std::size_t>(entry.integer("padding", 0, kCropSide / 2));
    LayerTensors tensors = read_tensors(file_, net_.layers.size());
    if (tensors.inputs != channels_) refuse(name + ".weight", inputs_text(), tensors.inputs);
    if (tensors.kernel > side_ + 2 * padding) refuse(name + ".weight", side_text(), tensors.kernel);
    check_sums(tensors, name, file_.file());
    if (is_last) check_results(tensors, name, file_.file());
    // A layer reads what the one before writes, blocks of outputs and all.
    const std::size_t inputs = net_.layers.empty() ? rounded_up(channels_, kInputQuad)
                                                   : rounded_up(channels_, kOutputBlock);
    channels_ = tensors.outputs;
    net_.layers.push_back(make_layer(std::move(tensors), stride, padding, side_, inputs));
    side_ = net_.layers.back().out_side();
  }

  std::string inputs_text() const { return fmt::format("{} inputs", channels_); }
  std::string side_text() const { return fmt::format("a kernel of at most {}", side_); }

  const Safetensors& file_;
  Net net_;
  std::size_t side_ = kCropSide, channels_ = 0;
};

Net read_net(const Safetensors& file) {
  Net net = NetReader(file).read();
  net.hash = hash_hex(file.bytes());
  return net;
}

}  // namespace

Net parse_net(std::string bytes, const std::string& name) {
  return read_net(Safetensors::parse(std::move(bytes), name));
}

Net load_net(const std::filesystem::path& file) {
  return read_net(Safetensors::load(file, kMostFileBytes));
}

}  // namespace graspdb
