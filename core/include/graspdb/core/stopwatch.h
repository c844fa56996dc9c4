// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

namespace graspdb {

// Runs from its making on, by a clock that is never set back. Milliseconds. Not thread-safe.
class Stopwatch {
 public:
  double ms() const { return Milliseconds(Clock::now() - begin_).count(); }

  // The same, and starts anew from there: laps leave no time out.
  double lap_ms() {
    const auto now = Clock::now();
    const Milliseconds lap = now - begin_;
    begin_ = now;
    return lap.count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  using Milliseconds = std::chrono::duration<double, std::milli>;

  Clock::time_point begin_ = Clock::now();
};

}  // namespace graspdb
