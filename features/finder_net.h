// SPDX-License-Identifier: MIT
// The weights of a learned finder, checked and ready to be used.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "convolution.h"

namespace graspdb {

struct FinderLayer {
  Convolution convolution;
  // With one, the layer reads the result before it, each pixel four times, and beside it that of
  // this layer, which is as large but for a row and a column.
  std::optional<std::size_t> beside;
};

struct FinderNet {
  std::vector<FinderLayer> layers;
  std::size_t cell = 1;  // pixels that one of the last result stands for, in width and height
  std::string hash;      // of the file's bytes
};

// The channels of the last result.
enum FramePart : std::size_t { kRest, kHand, kArm, kObject, kFramePartCount };

FinderNet load_finder_net(const std::filesystem::path& file);
FinderNet parse_finder_net(std::string bytes, const std::string& name);

}  // namespace graspdb
