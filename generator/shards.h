// SPDX-License-Identifier: MIT
// Finished shards on disk.
#pragma once

#include <filesystem>
#include <string>

#include "plan.h"

namespace graspdb {

// All that the shard's rows depend on, as JSON.
std::string shard_inputs(const Plan& plan, const Shard& shard);

// <hand>-<variant>-<grasp>-<hash of its inputs>.graspdb
std::filesystem::path shard_file(const std::filesystem::path& work, const Plan& plan,
                                 const Shard& shard);

// Whether the file is there and whole. A damaged one is as good as none.
bool is_finished(const std::filesystem::path& shard_file);

// Throws Error that names the shard, and the one of other inputs that lies in its place if there
// is one.
[[noreturn]] void fail_missing(const std::filesystem::path& shard_file);

}  // namespace graspdb
