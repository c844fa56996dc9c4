// SPDX-License-Identifier: MIT
// Results as tables for people.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "graspdb/evaluation/evaluation_set.h"
#include "graspdb/evaluation/metrics.h"

namespace graspdb {

// One line per answer, then oracle, random row and constant guess.
std::string error_table(const std::vector<std::pair<std::string, Summary>>& answers,
                        const Baselines& baselines);

std::string sequence_table(const SequenceEvaluation& sequence);
std::string set_tables(const SetEvaluation& set, FrameKind kind, std::size_t sequences);

}  // namespace graspdb
