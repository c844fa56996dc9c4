// SPDX-License-Identifier: MIT
// How long reading a hand takes for the frames of a video, and how much memory.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "graspdb/core/progress.h"
#include "graspdb/database/database.h"
#include "graspdb/tracker/tracker.h"

namespace graspdb {

struct Percentiles {  // of all timed frames, ms
  double p50 = 0, p95 = 0, p99 = 0;
};

// "processor" is the processor's time of the whole, all threads.
inline constexpr std::array kBenchStages = {"segment",  "describe", "search",
                                            "temporal", "total",    "processor"};

// Resident bytes of this process, as the kernel tells them.
struct ResidentMemory {
  double peak = 0;   // since the last search was closed
  double own = 0;    // not of a file
  double files = 0;  // of mapped files
};

struct SearchBench {
  std::string search;
  TrackerOptions tracker;
  double open_database_ms = 0, open_search_ms = 0;
  std::array<Percentiles, kBenchStages.size()> ms;
  double valid = 0;  // the share of frames with an answer
  ResidentMemory before, after;
};

struct TrackerBench {
  std::string video;
  int width = 0, height = 0, frames = 0;
  double load = 0;  // of the machine, processes that want to run, over the last minute
  std::vector<SearchBench> searches;
};

// Reads `frames` frames of the video's first 256, which are shown again, after a pass that is not
// timed. Once with each search, on one thread. Without a name the video is a sequence of the
// training set, rendered before. Frames are kept in memory: they count as the process's before.
TrackerBench bench_tracker(const Database& database, const std::string& video, int frames,
                           const Progress& progress = {});

std::string bench_table(const TrackerBench& bench);
nlohmann::json bench_json(const TrackerBench& bench);

}  // namespace graspdb
