// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <vector>

#include "graspdb/tracker/tracker.h"

namespace graspdb::cli {

// What `track` tells at its end.
struct TrackStatistics {
  std::size_t frames = 0;
  std::size_t seen = 0, valid = 0;  // with a mask of a hand; that resembles a row
  std::vector<double> segment, describe, search, temporal, total;  // ms per frame

  void add(const Estimate& estimate);
};
void print(const TrackStatistics& statistics, std::FILE* to);

}  // namespace graspdb::cli
