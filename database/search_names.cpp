// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "graspdb/core/error.h"
#include "graspdb/database/search.h"

namespace graspdb {

std::vector<std::vector<Neighbor>> Search::nearest_of_each(std::span<const DescriptorView> queries,
                                                           int k) const {
  std::vector<std::vector<Neighbor>> found;
  for (const DescriptorView query : queries) found.push_back(nearest(query, k));
  return found;
}

const std::vector<std::string>& search_names() {
  static const std::vector<std::string> names = {"exact", "scan", "lsh"};
  return names;
}

std::unique_ptr<Search> open_search(const Database& database, const std::string& name) {
  if (name == "exact") return make_exact_search(database);
  if (name == "scan") return make_scan_search(database);
  if (name == "lsh") return make_lsh_search(database);
  throw Error({.key = "search",
               .expected = fmt::format("{}", fmt::join(search_names(), ", ")),
               .found = name});
}

}  // namespace graspdb
