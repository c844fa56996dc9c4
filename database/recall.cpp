// SPDX-License-Identifier: MIT
#include <algorithm>

#include "graspdb/core/error.h"
#include "graspdb/database/search.h"

namespace graspdb {

double recall(const Search& search, const Search& exact,
              const std::vector<DescriptorBytes>& queries, int k) {
  GRASPDB_CHECK(k > 0 && !queries.empty());
  std::size_t found = 0, wanted = 0;
  for (const DescriptorBytes& query : queries) {
    const std::vector<Neighbor> truth = exact.nearest(query, k);
    if (truth.empty()) continue;
    wanted += truth.size();
    const std::uint32_t bound = truth.back().squared_distance;
    found += static_cast<std::size_t>(std::ranges::count_if(
        search.nearest(query, k),
        [bound](const Neighbor& neighbor) { return neighbor.squared_distance <= bound; }));
  }
  return wanted == 0 ? 1 : static_cast<double>(found) / static_cast<double>(wanted);
}

}  // namespace graspdb
