// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace graspdb {

// Bytes where memory is read fastest, for what is read as a whole for each query: in huge pages, if
// the system has them, and aligned to cache lines. std::bad_alloc when there are not as many.
class HugePages {
 public:
  explicit HugePages(std::size_t size);  // zeros
  explicit HugePages(std::span<const std::uint8_t> copied);

  std::span<std::uint8_t> bytes() { return {memory_.get(), size_}; }
  std::span<const std::uint8_t> bytes() const { return {memory_.get(), size_}; }

 private:
  struct Free {
    void operator()(std::uint8_t* memory) const;
  };
  struct Uninitialized {};
  HugePages(std::size_t size, Uninitialized);

  std::size_t size_;
  std::unique_ptr<std::uint8_t, Free> memory_;
};

}  // namespace graspdb
