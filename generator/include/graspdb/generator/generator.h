// SPDX-License-Identifier: MIT
// Makes a database: every hand x variant x grasp x step x view is one row, and a row is a pure
// function of the configuration and its number:
//   row = (((hand * variants + variant) * grasps + grasp ordinal) * steps + step - 1) * views +
//   view.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "graspdb/core/progress.h"
#include "graspdb/generator/build_config.h"

namespace graspdb {

// How a database is made; nothing of it changes a byte of the result.
//
// The rows are made in shards, one for each hand, variant and grasp. A finished shard is a small
// database in the folder `work`, named by a hash of all that its rows depend on: the hand, the
// closed grasp and its object, the options, the code that makes rows and the kind of processor. It
// is used again by every later build whose shard has that hash, so that a build that was stopped
// goes on, and one that adds a grasp makes only that grasp's rows.
struct BuildJob {
  std::filesystem::path out;
  std::filesystem::path work;  // empty: `out` with ".work" after it
  int shard = 0, shards = 1;   // of the shards only shard, shard + shards, shard + 2 shards, ...
  int threads = 0;             // 0 = all processors
  Progress progress;           // in rows, those found finished included
  std::function<bool()> stop;  // asked now and then; when it says so, the build ends with an Error
};

struct BuildReport {
  std::size_t rows = 0;           // of the database, or of this part of the shards
  std::size_t rendered_rows = 0;  // the others were found finished
  double seconds = 0;
  std::uintmax_t bytes = 0;  // of the database; 0 while shards are missing
  std::string content_hash;  // empty while shards are missing
};

// Makes the job's shards that are not finished and, when the job has all of them, joins them into
// `out`, aside and renamed. Throws Error for bad input, a full disk or a stop: finished shards stay
// in `work`, nothing else is left. The folder `work` may be shared by builds on several machines.
BuildReport build_database(const BuildConfig& config, const BuildJob& job);

// Joins the shards in `work` that builds with this configuration have made. Throws Error naming a
// shard that is missing or was made by other code or on another kind of processor. The
// configuration is the one that the builds left in `work`.
BuildReport merge_shards(const BuildJob& job);

}  // namespace graspdb
