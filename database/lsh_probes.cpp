// SPDX-License-Identifier: MIT
#include "lsh_probes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <tuple>

#include "graspdb/core/error.h"

namespace graspdb {

ProbeSequence::ProbeSequence(std::span<const float> projected) {
  GRASPDB_CHECK(!projected.empty() && projected.size() <= 32);
  for (std::size_t i = 0; i < projected.size(); ++i) {
    const float below = projected[i] - std::floor(projected[i]);
    const auto function = static_cast<std::uint8_t>(i);
    steps_.push_back({below * below, function, -1});
    steps_.push_back({(1 - below) * (1 - below), function, 1});
  }
  std::ranges::sort(steps_, {}, [](const Step& step) {
    return std::tuple(step.score, step.function, step.direction);
  });
  std::array<int, 32> first;
  first.fill(-1);
  opposites_.resize(steps_.size());
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    int& partner = first[steps_[i].function];
    if (partner < 0) {
      partner = static_cast<int>(i);
    } else {
      opposites_[i] = std::uint64_t{1} << partner;
      opposites_[static_cast<std::size_t>(partner)] = std::uint64_t{1} << i;
    }
  }
}

bool ProbeSequence::later(const Candidate& a, const Candidate& b) {
  return std::tie(a.score, a.set) > std::tie(b.score, b.set);
}

void ProbeSequence::push(const Candidate& candidate) {
  heap_.push_back(candidate);
  std::ranges::push_heap(heap_, later);
}

bool ProbeSequence::valid(std::uint64_t set) const {
  for (std::uint64_t rest = set; rest != 0; rest &= rest - 1) {
    if (set & opposites_[static_cast<std::size_t>(std::countr_zero(rest))]) return false;
  }
  return true;
}

bool ProbeSequence::next(std::uint64_t& set) {
  if (!started_) {
    started_ = true;
    push({steps_[0].score, 0, 1});
    set = 0;
    return true;
  }
  while (!heap_.empty()) {
    std::ranges::pop_heap(heap_, later);
    const Candidate best = heap_.back();
    heap_.pop_back();
    // Every set arises once: from the one whose last step is one earlier (moved on), or from the
    // one without its last step (added to).
    const auto last = static_cast<std::size_t>(best.last);
    if (last + 1 < steps_.size()) {
      const std::uint64_t added = best.set | std::uint64_t{2} << last;
      push({best.score + steps_[last + 1].score, best.last + 1, added});
      push({best.score - steps_[last].score + steps_[last + 1].score, best.last + 1,
            added & ~(std::uint64_t{1} << last)});
    }
    if (!valid(best.set)) continue;
    set = best.set;
    return true;
  }
  return false;
}

}  // namespace graspdb
