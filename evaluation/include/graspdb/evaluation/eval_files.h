// SPDX-License-Identifier: MIT
// What `graspdb eval` leaves behind; docs/evaluation.md names every key and column.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "graspdb/evaluation/evaluation_set.h"

namespace graspdb {

struct EvalReport {
  std::vector<SequenceEvaluation> sequences;
  SetEvaluation set;
};

nlohmann::json eval_json(
    const EvalReport& report);  // {rows, set, metrics}; what does not apply is null
// All the numbers of a tracker, by their keys.
nlohmann::json options_json(const TrackerOptions& options);
std::string frames_csv(const EvalReport& report);  // a line a frame, model and alpha
std::string runs_csv(const EvalReport& report);    // a line a run

}  // namespace graspdb
