// SPDX-License-Identifier: MIT
#include "graspdb/features/embedding.h"

#include <algorithm>
#include <cmath>

#include "graspdb/core/error.h"
#include "net.h"

namespace graspdb {
namespace {

PaddedPicture first_picture(const Net& net, const HandCrop& crop) {
  const Convolution& layer = net.layers.front();
  PaddedPicture picture(kCropSide, kCropSide, layer.inputs, layer.padding);
  for (std::size_t plane = 0; plane < net.planes.size(); ++plane) {
    const CropPlane& pixels = crop.*net.planes[plane];
    for (std::size_t i = 0; i < kCropPixels; ++i) {
      picture.row(i / kCropSide)[i % kCropSide * layer.inputs + plane] = pixels[i];
    }
  }
  return picture;
}

std::vector<std::int64_t> last_values(const Net& net, PaddedPicture picture) {
  for (std::size_t i = 0; i + 1 < net.layers.size(); ++i) {
    picture = convolve(net.layers[i], picture, net.layers[i + 1].padding);
  }
  std::vector<std::int32_t> row(net.layers.back().outputs);
  convolve_row(net.layers.back(), picture, 0, row);
  return {row.begin(), row.begin() + static_cast<std::ptrdiff_t>(net.size)};
}

// Rounded down.
std::int64_t square_root(std::int64_t square) {
  auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(square)));
  while (root * root > square) --root;
  while ((root + 1) * (root + 1) <= square) ++root;
  return root;
}

// Rounded to the nearest, a half away from 0.
std::int64_t quotient(std::int64_t dividend, std::int64_t divisor) {
  const std::int64_t half = dividend < 0 ? -divisor / 2 : divisor / 2;
  return (dividend + half) / divisor;
}

}  // namespace

struct EmbeddingNet::State {
  Net net;
};

EmbeddingNet::EmbeddingNet(std::unique_ptr<State> state) : state_(std::move(state)) {}
EmbeddingNet::~EmbeddingNet() = default;
EmbeddingNet::EmbeddingNet(EmbeddingNet&&) noexcept = default;
EmbeddingNet& EmbeddingNet::operator=(EmbeddingNet&&) noexcept = default;

EmbeddingNet EmbeddingNet::load(const std::filesystem::path& file) {
  return EmbeddingNet(std::make_unique<State>(State{load_net(file)}));
}

EmbeddingNet EmbeddingNet::parse(std::string bytes, const std::string& name) {
  return EmbeddingNet(std::make_unique<State>(State{parse_net(std::move(bytes), name)}));
}

std::size_t EmbeddingNet::size() const {
  return state_->net.size;
}

const std::string& EmbeddingNet::hash() const {
  return state_->net.hash;
}

Embedding EmbeddingNet::describe(const HandCrop& crop) const {
  const Net& net = state_->net;
  const std::vector<std::int64_t> values = last_values(net, first_picture(net, crop));
  std::int64_t square = 0;
  for (const std::int64_t value : values) square += value * value;
  const std::int64_t length = std::max(square_root(square), std::int64_t{1});
  Embedding code(values.size());
  std::ranges::transform(values, code.begin(), [&](std::int64_t value) {
    return static_cast<std::uint8_t>(
        std::clamp<std::int64_t>(128 + quotient(value * net.scale, length), 0, 255));
  });
  return code;
}

std::optional<Embedding> EmbeddingNet::describe(const GrayImage& gray, const Mask& mask) const {
  const auto square = crop_square(mask);
  if (!square) return std::nullopt;
  return describe(crop_hand(gray, mask, *square));
}

}  // namespace graspdb
