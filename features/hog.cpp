// SPDX-License-Identifier: MIT
#include "graspdb/features/hog.h"

#include "graspdb/core/error.h"
#include "hog_modes.h"

namespace graspdb {

std::string hog_name(HogMode mode) {
  switch (mode) {
    case HogMode::kPaper:
      return "paper";
    case HogMode::kSoftEdges:
      return "soft-edges";
  }
  GRASPDB_CHECK(false);
}

HogMode hog_from_name(std::string_view name, const std::string& file) {
  for (const HogMode mode : {HogMode::kPaper, HogMode::kSoftEdges}) {
    if (name == hog_name(mode)) return mode;
  }
  throw Error(
      {.file = file, .key = "hog", .expected = "paper or soft-edges", .found = std::string(name)});
}

Descriptor describe(const GrayImage& gray, const Mask& mask, HogMode mode) {
  GRASPDB_CHECK(gray.width() == mask.width() && gray.height() == mask.height());
  const std::optional<Box> box = tight_box(mask);
  if (!box) return {};
  switch (mode) {
    case HogMode::kPaper:
      return describe_paper(gray, mask, *box);
    case HogMode::kSoftEdges:
      return describe_soft_edges(gray, mask, *box);
  }
  GRASPDB_CHECK(false);
}

}  // namespace graspdb
