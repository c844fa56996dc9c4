// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "code_table.h"
#include "distance.h"
#include "exact.h"
#include "graspdb/core/error.h"
#include "graspdb/core/parallel.h"
#include "graspdb/database/search.h"
#include "pca.h"
#include "top_k.h"

namespace graspdb {
namespace {

constexpr std::size_t kSample = 8192;  // rows that the directions are fitted to
constexpr std::size_t kBatch = 512;    // rows whose codes are worked out at once
constexpr std::size_t kShortened = 4;  // by this factor codes are shorter than descriptors

void check_options(int dimensions, int rerank) {
  const auto refuse = [](const char* option, const char* expected, int found) {
    throw Error({.key = option, .expected = expected, .found = fmt::format("{}", found)});
  };
  if (dimensions < 2 || dimensions > kDescriptorSize || dimensions % 2 != 0)
    refuse("dimensions", "an even number, 2 to 512", dimensions);
  if (rerank < 1) refuse("rerank", "at least 1", rerank);
}

class ScanSearch : public Search {
 public:
  ScanSearch(const DescriptorTable& rows, int dimensions, int rerank)
      : rows_(rows), dimensions_(dimensions), rerank_(static_cast<std::size_t>(rerank)) {
    if (rows_.rows() == 0) return;
    pca_ = fit_pca(rows_, dimensions_, kSample);
    // One unit for all directions, so that distances between codes follow those between
    // descriptors; what lies beyond four standard deviations is cut off.
    scale_ = 127 / (4 * std::max(pca_.deviation, 1e-3F));
    encode_all();
  }

  std::vector<Neighbor> nearest(DescriptorView query, int k) const override {
    return nearest_of_each(std::span(&query, 1), k).front();
  }

  std::vector<std::vector<Neighbor>> nearest_of_each(std::span<const DescriptorView> queries,
                                                     int k) const override {
    GRASPDB_CHECK(k >= 0);
    const auto wanted = static_cast<std::size_t>(k);
    const auto kept = std::max(rerank_, 3 * wanted);
    std::vector<std::vector<Neighbor>> found;
    if (kept >= rows_.rows()) {
      for (const DescriptorView query : queries) found.push_back(exact_nearest(rows_, query, k));
      return found;
    }
    std::vector<std::vector<std::int8_t>> codes;
    for (const DescriptorView query : queries) {
      const Codes code = codes_of(query);
      codes.emplace_back(code.data(), code.data() + code.size());
    }
    const std::vector<std::vector<Neighbor>> likely = codes_->nearest(codes, kept);
    for (std::size_t i = 0; i < queries.size(); ++i)
      found.push_back(reranked(queries[i], likely[i], wanted));
    return found;
  }

 private:
  using Codes = Eigen::Matrix<std::int8_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  // The nearest of them by the descriptors themselves.
  std::vector<Neighbor> reranked(DescriptorView query, const std::vector<Neighbor>& likely,
                                 std::size_t wanted) const {
    std::vector<std::uint32_t> rows;
    for (const Neighbor& neighbor : likely) rows.push_back(neighbor.row);
    std::ranges::sort(rows);  // memory likes to be read in order
    std::vector<std::uint32_t> squared(rows.size());
    squared_distances(query, rows_.bytes.data(), rows, squared);
    TopK best(wanted);
    for (std::size_t i = 0; i < rows.size(); ++i) best.offer(rows[i], squared[i]);
    return best.take();
  }

  // A row each, whole numbers from -127 to 127.
  Codes codes_of(DescriptorView descriptors) const {
    const Eigen::MatrixXf scaled = project(pca_, {descriptors, rows_.size}) * scale_;
    return scaled.array().round().max(-127).min(127).cast<std::int8_t>();
  }

  static std::span<const std::int8_t> row_of(const Codes& codes, Eigen::Index row) {
    return {codes.data() + row * codes.cols(), static_cast<std::size_t>(codes.cols())};
  }

  void encode_all() {
    const std::size_t count = rows_.rows();
    codes_.emplace(count, static_cast<std::size_t>(dimensions_));
    parallel_for((count + kBatch - 1) / kBatch, 0, [&](std::size_t batch) {
      const std::size_t start = batch * kBatch, size = std::min(kBatch, count - start);
      const Codes codes = codes_of(rows_.bytes.subspan(start * rows_.size, size * rows_.size));
      for (std::size_t i = 0; i < size; ++i) {
        codes_->store(start + i, row_of(codes, static_cast<Eigen::Index>(i)));
      }
    });
  }

  DescriptorTable rows_;
  int dimensions_;
  std::size_t rerank_;
  Pca pca_;
  float scale_ = 1;
  std::optional<CodeTable> codes_;  // none of no rows
};

}  // namespace

std::unique_ptr<Search> make_scan_search(const Database& database, const ScanOptions& options) {
  const DescriptorTable rows = database.descriptors();
  const int dimensions = options.dimensions.value_or(static_cast<int>(rows.size / kShortened));
  check_options(dimensions, options.rerank);
  if (static_cast<std::size_t>(dimensions) >= rows.size) return make_exact_search(database);
  return std::make_unique<ScanSearch>(rows, dimensions, options.rerank);
}

}  // namespace graspdb
