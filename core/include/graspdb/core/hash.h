// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace graspdb {

// The XXH3 128-bit hash of some bytes, as 32 hexadecimal digits. It finds accidents, not forgers.
std::string hash_hex(std::span<const std::byte> bytes);
std::string hash_hex(std::string_view text);

// The same hash of bytes that come piece by piece. Not thread-safe.
class Hasher {
 public:
  Hasher();
  ~Hasher();
  void add(std::span<const std::byte> bytes);
  std::string hex() const;  // of all bytes so far

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace graspdb
