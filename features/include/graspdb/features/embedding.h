// SPDX-License-Identifier: MIT
// A learned descriptor: a small net in whole numbers that turns the crop of a hand into a short
// code. Codes of like poses lie near to each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "graspdb/core/descriptor.h"
#include "graspdb/features/crop.h"

namespace graspdb {

// Immutable; thread-safe.
class EmbeddingNet {
 public:
  // A file of weights (docs/descriptors.md). Throws Error naming file and key for one that is
  // altered, of another version or whose parts do not fit.
  static EmbeddingNet load(const std::filesystem::path& file);
  // `name` stands for the file in messages.
  static EmbeddingNet parse(std::string bytes, const std::string& name);
  ~EmbeddingNet();
  EmbeddingNet(EmbeddingNet&&) noexcept;
  EmbeddingNet& operator=(EmbeddingNet&&) noexcept;

  std::size_t size() const;         // bytes of a code
  const std::string& hash() const;  // of the file: rows and queries must have one
  // The direction of the net's last layer: 128 is 0, and the distance of two codes tells their
  // angle. The same bytes on every processor.
  Embedding describe(const HandCrop& crop) const;
  // The same of the mask's crop; none for an empty mask.
  std::optional<Embedding> describe(const GrayImage& gray, const Mask& mask) const;

 private:
  struct State;
  explicit EmbeddingNet(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace graspdb
