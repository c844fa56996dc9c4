// SPDX-License-Identifier: MIT
#include "graspdb/segmentation.h"

namespace graspdb {

Mask isolate_hand(const Mask& skin, const std::optional<Box>& roi, const SkinOptions& options) {
  const std::optional<Mask> region = largest_region(skin, options.min_area_px, roi);
  return region ? cut_forearm(*region) : Mask(skin.width(), skin.height());
}

}  // namespace graspdb
