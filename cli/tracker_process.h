// SPDX-License-Identifier: MIT
// A tracker in a process of its own, so that what the kernel says of the process it says of the
// tracker: no leftovers of a renderer, no other search, no frames that wait for their turn.
#pragma once

#include <sys/types.h>

#include <string>

#include "graspdb/image.h"
#include "graspdb/tracker.h"

namespace graspdb::cli {

struct StepTimes {  // milliseconds
  double segment = 0, describe = 0, search = 0, temporal = 0, total = 0;
  double processor = 0;  // of all threads: no more than the total when there is but one
  bool valid = false;
};

struct ResidentMemory {  // bytes
  double peak = 0;
  // At the time of asking: of the process alone, and of mapped files, libraries among them.
  double own = 0, files = 0;
};

struct Opening {
  ResidentMemory before;  // of the program as it starts, with all of its libraries
  double database_ms = 0, search_ms = 0;
  TrackerOptions tracker;  // what frames are read with: the defaults of `track`
};

// Answers one call at a time; a failure over there is thrown here, as an Error. Not thread-safe.
class TrackerProcess {
 public:
  // Starts this program anew.
  TrackerProcess(const std::string& database, const std::string& search);
  ~TrackerProcess();
  TrackerProcess(const TrackerProcess&) = delete;
  TrackerProcess& operator=(const TrackerProcess&) = delete;

  // In this order: once, any number of times, once.
  Opening open();
  StepTimes step(const ColorImage& frame);  // segmented by its colours, as `track` does
  ResidentMemory finish();

 private:
  template <typename Answer>
  Answer receive();

  int socket_ = -1;
  pid_t child_ = -1;
};

}  // namespace graspdb::cli
