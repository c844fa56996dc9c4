// SPDX-License-Identifier: MIT
// Nearest neighbours among a database's descriptors: embeddings where it has them, else HOGs.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "graspdb/core/descriptor.h"
#include "graspdb/database/database.h"

namespace graspdb {

struct Neighbor {
  std::uint32_t row = 0;
  std::uint32_t squared_distance = 0;  // between the u8 descriptors
  bool operator==(const Neighbor&) const = default;
};

// Its distance where a row's 255 counts as 1.
inline double descriptor_distance(const Neighbor& neighbor) {
  return std::sqrt(static_cast<double>(neighbor.squared_distance)) / 255;
}

// Searching is thread-safe. The database must outlive the search.
class Search {
 public:
  virtual ~Search() = default;
  // The k >= 0 nearest rows (fewer when the database has fewer), nearest first, ties by row.
  // The query is of the kind that Database::descriptors() holds.
  virtual std::vector<Neighbor> nearest(DescriptorView query, int k) const = 0;
  // The same of each query. A search that reads the whole database reads it once for all of them.
  virtual std::vector<std::vector<Neighbor>> nearest_of_each(
      std::span<const DescriptorView> queries, int k) const;
};

// The share of the k nearest rows, over these queries, that `search` finds too: 1 is perfect. Rows
// as near as the k-th count as found, whichever of them `search` gives.
double recall(const Search& search, const Search& exact,
              const std::vector<DescriptorBytes>& queries, int k);

// The exact distances to these rows of the database, in their order. `rows` are rows of it.
std::vector<Neighbor> measure(const Database& database, DescriptorView query,
                              std::span<const std::uint32_t> rows);

// Compares with every row in integers: the same answer on every processor. The oracle. Keeps a copy
// of the descriptors.
std::unique_ptr<Search> make_exact_search(const Database& database);

// Compares short codes (the widest directions of a principal component analysis, a byte each) with
// every row, then re-ranks the best by exact distance: reads a quarter of the bytes, and finds
// nearly the same rows. Making it reads the whole database.
struct ScanOptions {
  // Of a code, even, 2 to 512; a quarter of the descriptor's when absent.
  std::optional<int> dimensions;
  int rerank = 400;  // rows that are compared exactly, at least 1; never fewer than 3 k
};
// The exact search where descriptors are no longer than such codes. Throws Error that names an
// option out of range.
std::unique_ptr<Search> make_scan_search(const Database& database, const ScanOptions& options = {});

// Multi-probe p-stable LSH (Datar et al. 2004; Lv et al. 2007), the paper's; candidates are
// re-ranked by exact distance, and fewer than k of them make it an exact search. Reproducible from
// the seed.
struct LshOptions {
  int tables = 20;   // 1 to 1000
  int hashes = 18;   // projections a table, 1 to 32
  double width = 4;  // of a hash cell, as a multiple of the median distance between a row and its
                     // 20th nearest, 0.001 to 1000
  int probes = 20;   // buckets looked up a table, 1 to 1,000,000
  std::uint64_t seed = 0;
};
// Throws Error that names an option out of range.
std::unique_ptr<Search> make_lsh_search(const Database& database, const LshOptions& options = {});

// The searches by name, with their default options: "exact", "scan", "lsh".
const std::vector<std::string>& search_names();
// Finds nearly what "exact" finds, in less time and memory.
inline constexpr const char* kDefaultSearch = "scan";
// Throws Error for a name that is not among them.
std::unique_ptr<Search> open_search(const Database& database, const std::string& name);

}  // namespace graspdb
