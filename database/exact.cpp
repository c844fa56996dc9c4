// SPDX-License-Identifier: MIT
#include "exact.h"

#include <algorithm>
#include <array>

#include "code_table.h"
#include "distance.h"
#include "graspdb/core/error.h"
#include "graspdb/core/parallel.h"
#include "huge_pages.h"
#include "top_k.h"

namespace graspdb {
namespace {

// Of a copy of the descriptors: in the mapped file they lie as the columns before them leave them,
// and are read in one and a half times the time.
class ExactSearch : public Search {
 public:
  explicit ExactSearch(const Database& database) : copy_(database.hogs().bytes) {}

  std::vector<Neighbor> nearest(DescriptorView query, int k) const override {
    return exact_nearest({copy_.bytes(), kDescriptorSize}, query, k);
  }

 private:
  HugePages copy_;
};

// The same of short descriptors: compared as codes of small whole numbers, a row takes a quarter of
// the instructions or less.
class ExactCodeSearch : public Search {
 public:
  explicit ExactCodeSearch(const DescriptorTable& rows) : table_(rows.rows(), rows.size) {
    parallel_for(rows.rows(), 0,
                 [&](std::size_t row) { table_.store(row, code_of(rows.row(row))); });
  }

  std::vector<Neighbor> nearest(DescriptorView query, int k) const override {
    return nearest_of_each(std::span(&query, 1), k).front();
  }

  std::vector<std::vector<Neighbor>> nearest_of_each(std::span<const DescriptorView> queries,
                                                     int k) const override {
    GRASPDB_CHECK(k >= 0);
    std::vector<std::vector<std::int8_t>> codes;
    for (const DescriptorView query : queries) codes.push_back(code_of(query));
    return table_.nearest(codes, static_cast<std::size_t>(k));
  }

 private:
  static std::vector<std::int8_t> code_of(DescriptorView descriptor) {
    std::vector<std::int8_t> code(descriptor.size());
    std::ranges::transform(descriptor, code.begin(),
                           [](std::uint8_t byte) { return static_cast<std::int8_t>(byte - 128); });
    return code;
  }

  CodeTable table_;
};

}  // namespace

std::vector<Neighbor> exact_nearest(const DescriptorTable& rows, DescriptorView query, int k) {
  GRASPDB_CHECK(k >= 0 && query.size() == rows.size);
  const std::size_t count = rows.rows();
  TopK best(std::min(static_cast<std::size_t>(k), count));
  std::array<std::uint32_t, 512> squared;  // a block's, so that they stay in the first cache
  for (std::size_t start = 0; start < count; start += squared.size()) {
    const auto block = std::span(squared).first(std::min(squared.size(), count - start));
    squared_distances(query, rows.bytes.data() + start * rows.size, block);
    for (std::size_t i = 0; i < block.size(); ++i) {
      best.offer(static_cast<std::uint32_t>(start + i), block[i]);
    }
  }
  return best.take();
}

std::vector<Neighbor> measure(const Database& database, DescriptorView query,
                              std::span<const std::uint32_t> rows) {
  std::vector<std::uint32_t> squared(rows.size());
  squared_distances(query, database.descriptors().bytes.data(), rows, squared);
  std::vector<Neighbor> measured;
  measured.reserve(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) measured.push_back({rows[i], squared[i]});
  return measured;
}

std::unique_ptr<Search> make_exact_search(const Database& database) {
  if (database.has_embeddings()) return std::make_unique<ExactCodeSearch>(database.descriptors());
  return std::make_unique<ExactSearch>(database);
}

}  // namespace graspdb
