// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace graspdb {

// A counter-based random stream: the i-th number is a pure function of (seed, stream, i), so that
// work split between threads or shards draws the same numbers. Mixing is SplitMix64's finaliser
// (Steele, Lea, Flood 2014). Seed 0 is as good as any. Not for cryptography.
class RandomStream {
 public:
  explicit RandomStream(std::uint64_t seed, std::uint64_t stream = 0);

  std::uint64_t bits();                      // 64 random bits
  double uniform();                          // [0, 1)
  double uniform(double low, double high);   // [low, high)
  double normal();                           // mean 0, standard deviation 1
  std::uint64_t below(std::uint64_t bound);  // 0 <= n < bound, bound > 0
  void skip() { ++counter_; }                // as bits(), for one that is not looked at

 private:
  std::uint64_t key_;
  std::uint64_t counter_ = 0;
};

}  // namespace graspdb
