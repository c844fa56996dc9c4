// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "distance.h"
#include "graspdb/error.h"
#include "graspdb/search.h"
#include "top_k.h"

namespace graspdb {
namespace {

class ExactSearch : public Search {
 public:
  explicit ExactSearch(const Database& database)
      : rows_(database.hogs().data()), count_(database.rows()) {}

  std::vector<Neighbor> nearest(const Descriptor& query, int k) const override {
    GRASPDB_CHECK(k >= 0);
    TopK best(std::min(static_cast<std::size_t>(k), count_));
    std::array<std::uint32_t, 512> squared;  // a block's, so that they stay in the first cache
    for (std::size_t start = 0; start < count_; start += squared.size()) {
      const std::size_t size = std::min(squared.size(), count_ - start);
      squared_distances(query, rows_ + start * kDescriptorSize, std::span(squared).first(size));
      for (std::size_t i = 0; i < size; ++i) {
        best.offer(static_cast<std::uint32_t>(start + i), squared[i]);
      }
    }
    return best.take();
  }

 private:
  const std::uint8_t* rows_;
  std::size_t count_;
};

}  // namespace

std::unique_ptr<Search> make_exact_search(const Database& database) {
  return std::make_unique<ExactSearch>(database);
}

}  // namespace graspdb
