// SPDX-License-Identifier: MIT
// One verb is one file: add_VERB registers its options and what it does when it is called.
#pragma once

#include <CLI/CLI.hpp>

namespace graspdb::cli {

// The program's exit status when it did its work and found no hand, as a CLI::RuntimeError carries
// it; 1 is a fault, 2 wrong use.
constexpr int kNothingFound = 3;

void add_bench(CLI::App& app);
void add_build(CLI::App& app);
void add_diff(CLI::App& app);
void add_eval(CLI::App& app);
void add_export(CLI::App& app);
void add_find(CLI::App& app);
void add_grasp(CLI::App& app);
void add_hand(CLI::App& app);
void add_info(CLI::App& app);  // info and verify
void add_merge(CLI::App& app);
void add_query(CLI::App& app);
void add_render(CLI::App& app);
void add_samples(CLI::App& app);
void add_scenes(CLI::App& app);
void add_sequence(CLI::App& app);
void add_track(CLI::App& app);
void add_tune(CLI::App& app);

}  // namespace graspdb::cli
