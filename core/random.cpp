// SPDX-License-Identifier: MIT
#include "graspdb/core/random.h"

#include <cmath>

#include "graspdb/core/error.h"
#include "graspdb/core/transform.h"

namespace graspdb {
namespace {

constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15ULL;

std::uint64_t mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
  return z ^ (z >> 31);
}

}  // namespace

RandomStream::RandomStream(std::uint64_t seed, std::uint64_t stream)
    : key_(mix(mix(seed + kGolden) ^ (stream * kGolden))) {}

std::uint64_t RandomStream::bits() {
  return mix(key_ + kGolden * ++counter_);
}

double RandomStream::uniform() {
  return static_cast<double>(bits() >> 11) * 0x1.0p-53;
}

double RandomStream::uniform(double low, double high) {
  return low + (high - low) * uniform();
}

double RandomStream::normal() {
  const double radius = std::sqrt(-2 * std::log(1 - uniform()));
  return radius * std::cos(2 * kPi * uniform());
}

std::uint64_t RandomStream::below(std::uint64_t bound) {
  GRASPDB_CHECK(bound > 0);
  return bits() % bound;  // the bias is below bound / 2^64
}

}  // namespace graspdb
