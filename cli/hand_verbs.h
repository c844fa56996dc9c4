// SPDX-License-Identifier: MIT
// What the verbs of `graspdb hand` share.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <string>

namespace graspdb::cli {

inline const std::array<std::string, 4> kDefaultHands = {"male", "female", "slender", "child"};

void add_hand_check(CLI::App& hand);

}  // namespace graspdb::cli
