// SPDX-License-Identifier: MIT
// Rows of a database as a COCO keypoints data set (docs/export.md).
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "graspdb/core/progress.h"
#include "graspdb/database/database.h"

namespace graspdb {

struct CocoOptions {
  std::vector<std::size_t> rows;  // ascending, at least one; a file is named by its row
  std::optional<int> resolution;  // pixels a side, 16..1024; none: the database's
  bool amodal = false;            // also hand_amodal/ and object_amodal/
  bool depth = false;             // also depth/, 16 bits, mm
  int threads = 0;                // as in parallel_for
  Progress progress;              // in rows
};

// Writes images/ (shading, 8-bit grey), masks/ (0 background, 1 hand, 2 object) and, when all of
// them are there, annotations.json, aside and renamed: a folder without it is not finished. The
// files are the same whatever the number of threads. Throws Error for bad input, for a folder that
// holds something else than an export, and for files that have changed since the database was
// built.
void export_coco(const Database& database, const std::filesystem::path& directory,
                 const CocoOptions& options);

}  // namespace graspdb
