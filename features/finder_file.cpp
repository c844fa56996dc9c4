// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>

#include "finder_net.h"
#include "graspdb/core/error.h"
#include "graspdb/core/hash.h"
#include "graspdb/core/json/strict_json.h"
#include "graspdb/core/rounded_up.h"
#include "layer_file.h"

namespace graspdb {
namespace {

using nlohmann::json;

constexpr std::array kPartNames = {"rest", "hand", "arm", "object"};  // as FramePart counts them
constexpr std::size_t kColors = 3;
constexpr std::size_t kMostHalvings = 5;

// Reads layers one after the other. Each halves the picture or leaves its size, so that sizes fit
// whatever the frame's is.
class FinderReader {
 public:
  explicit FinderReader(const Safetensors& file) : file_(file) {}

  FinderNet read() {
    expect_metadata(file_, "format", "graspdb finder");
    expect_metadata(file_, "format_version", "1");
    expect_metadata(file_, "score_step", "0.0625");  // colours are weighed in the same steps
    if (metadata_list(file_, "parts", kFramePartCount) != json(kPartNames)) {
      throw Error({file_.file(), "parts", json(kPartNames).dump(), file_.metadata("parts")});
    }
    const json layers = metadata_list(file_, "layers", kMostLayers);
    for (const json& entry : layers) {
      add(JsonFields(entry, file_.file(), "layers"), &entry == &layers.back());
    }
    expect_no_more_tensors(file_, layers.size());
    if (results_.back().channels.count != kFramePartCount) {
      refuse(file_, "layers", "4 outputs at the end", results_.back().channels.count);
    }
    net_.cell = std::size_t{1} << results_.back().halvings;
    net_.hash = hash_hex(file_.bytes());
    return std::move(net_);
  }

 private:
  struct Result {
    Channels channels;
    std::size_t halvings = 0;  // of the frame's size
  };

  Result previous() const {
    const Result frame{.channels = {kColors, rounded_up(kColors, kInputQuad)}};
    return results_.empty() ? frame : results_.back();
  }

  std::optional<std::size_t> beside(const JsonFields& entry) const {
    if (!entry.has("beside")) return std::nullopt;
    const auto number = static_cast<std::size_t>(entry.natural("beside"));
    if (number >= results_.size() || results_[number].halvings + 1 != previous().halvings) {
      refuse(file_, "layers.beside", "an earlier layer whose result is twice as large", number);
    }
    return number;
  }

  void add(const JsonFields& entry, bool is_last) {
    const LayerPlace place{
        .number = net_.layers.size(),
        .stride = static_cast<std::size_t>(entry.integer("stride", 1, 2)),
        .padding = static_cast<std::size_t>(entry.integer("padding", 0, kLargestKernel / 2)),
        .is_last = is_last};
    std::vector<Channels> inputs{previous().channels};
    std::size_t halvings = previous().halvings + place.stride - 1;
    const std::optional<std::size_t> beside_layer = beside(entry);
    if (beside_layer) {
      inputs.push_back(results_[*beside_layer].channels);
      --halvings;
    }
    if (halvings > kMostHalvings)
      refuse(file_, "layers.stride", "sizes halved 5 times at most", halvings);
    ReadLayer layer = read_layer(file_, place, inputs);
    if (layer.convolution.kernel != 2 * place.padding + 1) {
      refuse(file_, fmt::format("layer{}.weight", place.number),
             fmt::format("a kernel of {}", 2 * place.padding + 1), layer.convolution.kernel);
    }
    results_.push_back({channels_of(layer.outputs), halvings});
    net_.layers.push_back({std::move(layer.convolution), beside_layer});
  }

  const Safetensors& file_;
  FinderNet net_;
  std::vector<Result> results_;  // of each layer
};

}  // namespace

FinderNet parse_finder_net(std::string bytes, const std::string& name) {
  return FinderReader(Safetensors::parse(std::move(bytes), name)).read();
}

FinderNet load_finder_net(const std::filesystem::path& file) {
  return FinderReader(Safetensors::load(file, kMostFileBytes)).read();
}

}  // namespace graspdb
