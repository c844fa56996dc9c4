// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "graspdb/database/search.h"

namespace graspdb {

// Keeps the k nearest of the rows it is offered, in any order. Distance and row make one number,
// so that ties go to the smaller row. Twice k are held before the worse half is dropped: offering
// costs a comparison for most rows.
class TopK {
 public:
  static constexpr std::uint32_t kNoBound = std::numeric_limits<std::uint32_t>::max();

  // Rows that are no nearer than `bound` are not kept.
  explicit TopK(std::size_t k, std::uint32_t bound = kNoBound)
      : k_(k), bound_(k == 0 ? 0 : std::uint64_t{bound} << 32) {
    keys_.reserve(2 * k);
  }

  void offer(std::uint32_t row, std::uint32_t squared_distance) {
    const std::uint64_t key = std::uint64_t{squared_distance} << 32 | row;
    if (key >= bound_) return;
    keys_.push_back(key);
    if (keys_.size() == 2 * k_) drop_worse_half();
  }

  // No row further than this is kept.
  std::uint32_t bound() const { return static_cast<std::uint32_t>(bound_ >> 32); }

  bool is_full() const { return keys_.size() >= k_; }

  // Nearest first.
  std::vector<Neighbor> take() {
    std::sort(keys_.begin(), keys_.end());
    keys_.resize(std::min(keys_.size(), k_));
    std::vector<Neighbor> neighbors;
    neighbors.reserve(keys_.size());
    for (const std::uint64_t key : keys_) {
      neighbors.push_back({static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32)});
    }
    return neighbors;
  }

 private:
  void drop_worse_half() {
    const auto kth = keys_.begin() + static_cast<std::ptrdiff_t>(k_) - 1;
    std::nth_element(keys_.begin(), kth, keys_.end());
    bound_ = *kth;
    keys_.resize(k_);
  }

  std::size_t k_;
  std::uint64_t bound_;
  std::vector<std::uint64_t> keys_;
};

}  // namespace graspdb
