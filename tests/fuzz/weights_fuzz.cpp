// SPDX-License-Identifier: MIT
// Whatever a file of weights holds: it describes a picture, or an Error refuses it.
#include <cstdlib>

#include "graspdb/core/error.h"
#include "graspdb/features/embedding.h"
#include "memory_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  graspdb::HandCrop crop;
  for (std::size_t i = 0; i < graspdb::kCropPixels; ++i) {
    crop.gray[i] = crop.mask[i] = crop.scene[i] = static_cast<std::uint8_t>(i * 37);
  }
  try {
    const auto net =
        graspdb::EmbeddingNet::parse(std::string(graspdb::testing::text_of(data, size)), "weights");
    if (net.describe(crop).size() != net.size()) std::abort();
  } catch (const graspdb::Error&) {
  }
  return 0;
}
