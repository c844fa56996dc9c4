// SPDX-License-Identifier: MIT
#include "huge_pages.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <new>

namespace graspdb {

HugePages::HugePages(std::size_t size, Uninitialized) : size_(size) {
  constexpr std::size_t kHugePage = 2 << 20;
  const std::size_t whole = (size / kHugePage + 1) * kHugePage;
  memory_.reset(static_cast<std::uint8_t*>(std::aligned_alloc(kHugePage, whole)));
  if (!memory_) throw std::bad_alloc();
  ::madvise(memory_.get(), whole, MADV_HUGEPAGE);  // a wish: small pages do as well
}

HugePages::HugePages(std::size_t size) : HugePages(size, Uninitialized()) {
  std::memset(memory_.get(), 0, size);
}

HugePages::HugePages(std::span<const std::uint8_t> copied)
    : HugePages(copied.size(), Uninitialized()) {
  std::ranges::copy(copied, memory_.get());
}

void HugePages::Free::operator()(std::uint8_t* memory) const {
  std::free(memory);
}

}  // namespace graspdb
