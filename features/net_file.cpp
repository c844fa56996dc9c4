// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "graspdb/core/descriptor.h"
#include "graspdb/core/error.h"
#include "graspdb/core/hash.h"
#include "graspdb/core/json/strict_json.h"
#include "graspdb/core/rounded_up.h"
#include "layer_file.h"
#include "net.h"

namespace graspdb {
namespace {

using nlohmann::json;

constexpr const char* kFormat = "graspdb descriptor";
constexpr const char* kFormatVersion = "2";
constexpr int kMostScale = 4096;

std::vector<CropPlane HandCrop::*> read_planes(const Safetensors& file) {
  constexpr std::pair<const char*, CropPlane HandCrop::*> kPlanes[] = {
      {"gray", &HandCrop::gray}, {"mask", &HandCrop::mask}, {"scene", &HandCrop::scene}};
  std::vector<CropPlane HandCrop::*> planes;
  for (const json& name : metadata_list(file, "planes", std::size(kPlanes))) {
    const auto* known = std::ranges::find_if(
        kPlanes, [&](const auto& plane) { return name.is_string() && name == plane.first; });
    if (known == std::end(kPlanes)) {
      throw Error({file.file(), "planes", "gray, mask or scene", name.dump()});
    }
    planes.push_back(known->second);
  }
  return planes;
}

// Reads layers one after the other, each for what the one before gives.
class NetReader {
 public:
  explicit NetReader(const Safetensors& file) : file_(file) {}

  Net read() {
    expect_metadata(file_, "format", kFormat);
    expect_metadata(file_, "format_version", kFormatVersion);
    net_.planes = read_planes(file_);
    channels_ = {net_.planes.size(), rounded_up(net_.planes.size(), kInputQuad)};
    const json layers = metadata_list(file_, "layers", kMostLayers);
    for (const json& entry : layers) {
      add(JsonFields(entry, file_.file(), "layers"), &entry == &layers.back());
    }
    expect_no_more_tensors(file_, layers.size());
    if (side_ != 1) refuse(file_, "layers", "one pixel at the end", side_);
    if (!is_embedding_size(channels_.count)) {
      refuse(file_, "layers", "64 or 128 outputs at the end", channels_.count);
    }
    net_.size = channels_.count;
    net_.scale = read_scale();
    net_.hash = hash_hex(file_.bytes());
    return std::move(net_);
  }

 private:
  int read_scale() const {
    const std::string key = "embedding_scale";
    const json fields{{key, parse_strict_json(file_.metadata(key), file_.file(), key)}};
    return JsonFields(fields, file_.file(), "").integer(key, 1, kMostScale);
  }

  void add(const JsonFields& entry, bool is_last) {
    const LayerPlace place{
        .number = net_.layers.size(),
        .stride = static_cast<std::size_t>(entry.integer("stride", 1, kCropSide)),
        .padding = static_cast<std::size_t>(entry.integer("padding", 0, kCropSide / 2)),
        .is_last = is_last};
    ReadLayer layer = read_layer(file_, place, {channels_});
    const std::size_t kernel = layer.convolution.kernel;
    if (kernel > side_ + 2 * place.padding) {
      refuse(file_, fmt::format("layer{}.weight", place.number),
             fmt::format("a kernel of at most {}", side_ + 2 * place.padding), kernel);
    }
    channels_ = channels_of(layer.outputs);
    side_ = layer.convolution.out_size(side_);
    net_.layers.push_back(std::move(layer.convolution));
  }

  const Safetensors& file_;
  Net net_;
  std::size_t side_ = kCropSide;  // of what the next layer reads
  Channels channels_;
};

}  // namespace

Net parse_net(std::string bytes, const std::string& name) {
  return NetReader(Safetensors::parse(std::move(bytes), name)).read();
}

Net load_net(const std::filesystem::path& file) {
  return NetReader(Safetensors::load(file, kMostFileBytes)).read();
}

}  // namespace graspdb
