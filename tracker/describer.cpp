// SPDX-License-Identifier: MIT
#include "graspdb/tracker/describer.h"

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/features/embedding.h"
#include "graspdb/features/hog.h"

namespace graspdb {
namespace {

EmbeddingNet load_weights(const DatabaseInfo& info, const std::filesystem::path& file) {
  EmbeddingNet net = EmbeddingNet::load(file);
  if (net.hash() == info.weights && net.size() == info.embedding_bytes) return net;
  throw Error({file.string(), "", "the weights that the database was made with, " + info.weights,
               net.hash()});
}

}  // namespace

struct Describer::State {
  HogMode hog;
  std::unique_ptr<const EmbeddingNet> net;  // null: HOGs
};

std::filesystem::path weights_file(const std::string& descriptor) {
  return data_directory() / "assets" / "descriptors" / (descriptor + ".safetensors");
}

Describer::Describer(const Database& database, const std::filesystem::path& weights) {
  const DatabaseInfo& info = database.info();
  auto state = std::make_unique<State>();
  state->hog = hog_from_name(info.hog, database.path().string());
  if (database.has_embeddings()) {
    const auto file = weights.empty() ? weights_file(info.descriptor) : weights;
    state->net = std::make_unique<EmbeddingNet>(load_weights(info, file));
  }
  state_ = std::move(state);
}

Describer::~Describer() = default;
Describer::Describer(Describer&&) noexcept = default;

DescriptorBytes Describer::describe(const GrayImage& gray, const Mask& mask) const {
  if (state_->net) return state_->net->describe(gray, mask).value_or(Embedding{});
  const Descriptor hog = graspdb::describe(gray, mask, state_->hog);
  return {hog.begin(), hog.end()};
}

}  // namespace graspdb
