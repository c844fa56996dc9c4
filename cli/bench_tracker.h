// SPDX-License-Identifier: MIT
// How long the tracker takes for the frames of a video and how much memory it needs, held against
// what it may.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "graspdb/database.h"
#include "tracker_process.h"

namespace graspdb::cli {

struct Stage {
  const char* name;
  double StepTimes::*ms;
};
inline constexpr std::array<Stage, 6> kStages = {{{"segment", &StepTimes::segment},
                                                  {"describe", &StepTimes::describe},
                                                  {"search", &StepTimes::search},
                                                  {"temporal", &StepTimes::temporal},
                                                  {"total", &StepTimes::total},
                                                  {"processor", &StepTimes::processor}}};
inline constexpr std::size_t kTotal = 4;
static_assert(kStages[kTotal].ms == &StepTimes::total);

struct Percentiles {  // of all timed frames
  double p50 = 0, p95 = 0, p99 = 0;
};

struct TrackerFigures {
  std::string search;
  Opening opening;
  std::array<Percentiles, kStages.size()> ms;
  double valid = 0;  // the share of frames with an answer
  ResidentMemory memory;
};

struct TrackerBench {
  std::string video;
  int width = 0, height = 0, frames = 0;
  double load = 0;  // of the machine, processes that want to run, over the last minute
  std::vector<TrackerFigures> trackers;
};

// Tracks `frames` frames of the video, after a pass that is not timed; a shorter video is shown
// again. Once with each search, with lsh only where there is an index. Without a name the video is
// a sequence of the training set, rendered before.
TrackerBench bench_tracker(const Database& database, const std::string& video, int frames);

void print(const TrackerBench& bench);
nlohmann::json to_json(const TrackerBench& bench);

}  // namespace graspdb::cli
