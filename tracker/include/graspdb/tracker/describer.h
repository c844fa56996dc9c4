// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "graspdb/core/descriptor.h"
#include "graspdb/core/image.h"
#include "graspdb/database/database.h"

namespace graspdb {

// The file of a learned descriptor that has a name: assets/descriptors/NAME.safetensors in the data
// directory.
std::filesystem::path weights_file(const std::string& descriptor);

// Describes a picture as the rows of a database are: with the weights of its embeddings where it
// has them, else as its HOGs are made. Immutable; thread-safe; needs the database no longer.
class Describer {
 public:
  // `weights` empty: the file that the database names. Throws Error for weights that are not those
  // of the rows, and for a HOG that is not known.
  explicit Describer(const Database& database, const std::filesystem::path& weights = {});
  ~Describer();
  Describer(Describer&&) noexcept;

  // Of the size of Database::descriptors(). `gray` and `mask` are of one size; an empty mask gives
  // a HOG of zeros, or no bytes of an embedding.
  DescriptorBytes describe(const GrayImage& gray, const Mask& mask) const;

 private:
  struct State;
  std::unique_ptr<const State> state_;
};

}  // namespace graspdb
