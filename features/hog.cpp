// SPDX-License-Identifier: MIT
#include "graspdb/hog.h"

#include "graspdb/error.h"
#include "hog_modes.h"

namespace graspdb {

std::string hog_name(const HogOptions& options) {
  switch (options.mode) {
    case HogMode::kPaper:
      return "paper";
    case HogMode::kEdges:
      return "soft-edges";
  }
  GRASPDB_CHECK(false);
}

HogOptions hog_from_name(std::string_view name, const std::string& file) {
  for (const HogMode mode : {HogMode::kPaper, HogMode::kEdges}) {
    if (name == hog_name({mode})) return {mode};
  }
  throw Error(
      {.file = file, .key = "hog", .expected = "paper or soft-edges", .found = std::string(name)});
}

Descriptor describe(const GrayImage& gray, const Mask& mask, const HogOptions& options) {
  GRASPDB_CHECK(gray.width() == mask.width() && gray.height() == mask.height());
  const std::optional<Box> box = tight_box(mask);
  if (!box) return {};
  switch (options.mode) {
    case HogMode::kPaper:
      return describe_paper(gray, mask, *box);
    case HogMode::kEdges:
      return describe_edges(gray, mask, *box);
  }
  GRASPDB_CHECK(false);
}

}  // namespace graspdb
