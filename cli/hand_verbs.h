// SPDX-License-Identifier: MIT
// What the verbs of `graspdb hand` share.
#pragma once

#include <CLI/CLI.hpp>

namespace graspdb::cli {

void add_hand_check(CLI::App& hand);

}  // namespace graspdb::cli
