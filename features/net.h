// SPDX-License-Identifier: MIT
// The weights of a learned descriptor, checked and ready to be used.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "convolution.h"
#include "graspdb/features/crop.h"

namespace graspdb {

struct Net {
  std::vector<CropPlane HandCrop::*> planes;  // what the first layer reads
  std::vector<Convolution> layers;            // the last one's result is one pixel
  std::size_t size = 0;                       // bytes of a code: the last layer's outputs
  int scale = 0;                              // of a code whose values are a direction
  std::string hash;                           // of the file's bytes
};

Net load_net(const std::filesystem::path& file);
Net parse_net(std::string bytes, const std::string& name);

}  // namespace graspdb
