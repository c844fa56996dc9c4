// SPDX-License-Identifier: MIT
// One verb is one file: add_VERB registers its options and what it does when it is called.
#pragma once

#include <CLI/CLI.hpp>

namespace graspdb::cli {

void add_bench(CLI::App& app);
void add_build(CLI::App& app);
void add_diff(CLI::App& app);
void add_eval(CLI::App& app);
void add_export(CLI::App& app);
void add_grasp(CLI::App& app);
void add_hand(CLI::App& app);
void add_info(CLI::App& app);  // info and verify
void add_merge(CLI::App& app);
void add_query(CLI::App& app);
void add_render(CLI::App& app);
void add_sequence(CLI::App& app);
void add_track(CLI::App& app);
void add_tune(CLI::App& app);

}  // namespace graspdb::cli
