// SPDX-License-Identifier: MIT
// What all verbs share: progress on stderr, default places of data, opening searches.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "graspdb/database.h"
#include "graspdb/grasp.h"
#include "graspdb/hand.h"
#include "graspdb/progress.h"
#include "graspdb/search.h"

namespace graspdb::cli {

// On a terminal a bar with rate and time left; elsewhere a line every few seconds. A total of 0 is
// unknown. The bar ends when done and total are equal.
Progress console_progress(const std::string& what, const std::string& unit);

// A check of CLI11, whose ranges let NaN pass: an empty answer says that all is well.
std::string check_not_nan(const std::string& number);

std::filesystem::path default_hand();  // assets/hands/male.glb
std::filesystem::path grasp_directory();

const std::vector<std::string>& search_names();  // "exact", "scan", "lsh"

// One of those names; lsh takes the index beside the database when there is one.
std::unique_ptr<Search> open_search(const Database& database, const std::string& method);
std::filesystem::path index_file(const Database& database, const std::string& method);

}  // namespace graspdb::cli
