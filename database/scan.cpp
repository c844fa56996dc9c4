// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "code_distance.h"
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
constexpr std::size_t kBatch = 32;     // blocks scanned at once: they stay in a cache
constexpr std::size_t kBatchRows = kBatch * kCodeBlock;

void check_options(const ScanOptions& options) {
  const auto refuse = [](const char* option, const char* expected, int found) {
    throw Error({.key = option, .expected = expected, .found = fmt::format("{}", found)});
  };
  if (options.dimensions < 2 || options.dimensions > kDescriptorSize ||
      options.dimensions % 2 != 0) {
    refuse("dimensions", "an even number, 2 to 512", options.dimensions);
  }
  if (options.rerank < 1) refuse("rerank", "at least 1", options.rerank);
}

class ScanSearch : public Search {
 public:
  ScanSearch(const Database& database, const ScanOptions& options)
      : rows_(database.descriptors()), count_(database.rows()), options_(options) {
    check_options(options);
    if (count_ == 0) return;
    options_.dimensions = std::min(options.dimensions, static_cast<int>(rows_.size));
    pca_ = fit_pca(rows_, options_.dimensions, kSample);
    // One unit for all directions, so that distances between codes follow those between
    // descriptors; what lies beyond four standard deviations is cut off.
    scale_ = 127 / (4 * std::max(pca_.deviation, 1e-3F));
    encode_all();
  }

  std::vector<Neighbor> nearest(DescriptorView query, int k) const override {
    GRASPDB_CHECK(k >= 0);
    const auto wanted = static_cast<std::size_t>(k);
    const auto kept = std::max(static_cast<std::size_t>(options_.rerank), 4 * wanted);
    if (kept >= count_) return exact_nearest(rows_, query, k);
    TopK best(wanted);
    std::vector<std::uint32_t> rows = nearest_codes(query, kept);
    std::ranges::sort(rows);  // memory likes to be read in order
    std::vector<std::uint32_t> squared(rows.size());
    squared_distances(query, rows_.bytes.data(), rows, squared);
    for (std::size_t i = 0; i < rows.size(); ++i) best.offer(rows[i], squared[i]);
    return best.take();
  }

 private:
  // A row each, whole numbers from -127 to 127.
  Eigen::MatrixXf codes_of(DescriptorView descriptors) const {
    const Eigen::MatrixXf scaled = project(pca_, {descriptors, rows_.size}) * scale_;
    return scaled.array().round().max(-127).min(127);
  }

  void encode_all() {
    const std::size_t batches = (count_ + kBatchRows - 1) / kBatchRows;
    codes_.resize(batches * kBatchRows * static_cast<std::size_t>(options_.dimensions));
    norms_.resize(batches * kBatchRows);
    parallel_for(batches, 0, [&](std::size_t batch) {
      const std::size_t start = batch * kBatchRows, size = std::min(kBatchRows, count_ - start);
      const Eigen::MatrixXf codes =
          codes_of(rows_.bytes.subspan(start * rows_.size, size * rows_.size));
      for (std::size_t i = 0; i < size; ++i)
        store(start + i, codes.row(static_cast<Eigen::Index>(i)));
    });
  }

  // Puts one code where code_distance.h wants it.
  void store(std::size_t row, const Eigen::RowVectorXf& code) {
    const auto dimensions = static_cast<std::size_t>(options_.dimensions);
    const std::size_t block = row / kCodeBlock * kCodeBlock * dimensions;
    for (std::size_t i = 0; i < dimensions; ++i) {
      codes_[block + i / 2 * 2 * kCodeBlock + row % kCodeBlock * 2 + i % 2] =
          static_cast<std::int8_t>(code[static_cast<Eigen::Index>(i)]);
    }
    norms_[row] = static_cast<std::int32_t>(code.squaredNorm());
  }

  // The rows of the nearest codes, in no order.
  std::vector<std::uint32_t> nearest_codes(DescriptorView query, std::size_t count) const {
    const Eigen::RowVectorXf code = codes_of(query);
    std::vector<std::int32_t> pairs;
    for (Eigen::Index i = 0; i < code.size(); i += 2) {
      pairs.push_back(
          code_pair(static_cast<std::int8_t>(code[i]), static_cast<std::int8_t>(code[i + 1])));
    }
    TopK best(count);
    for (std::size_t start = 0; start < count_; start += kBatchRows) {
      scan_batch(pairs, static_cast<std::int32_t>(code.squaredNorm()), start, best);
    }
    std::vector<std::uint32_t> rows;
    for (const Neighbor& neighbor : best.take()) rows.push_back(neighbor.row);
    return rows;
  }

  void scan_batch(std::span<const std::int32_t> query, std::int32_t query_norm, std::size_t start,
                  TopK& best) const {
    std::array<std::int32_t, kBatchRows> squared;
    std::array<bool, kBatch> near;
    // A row as near as the bound comes behind the one that set it, so that only nearer ones count.
    const std::uint32_t bound =
        std::min<std::uint32_t>(best.bound(), std::numeric_limits<std::int32_t>::max());
    code_distances(query, query_norm, codes_.data() + start * 2 * query.size(),
                   norms_.data() + start, static_cast<std::int32_t>(bound), squared, near);
    for (std::size_t block = 0; block < kBatch; ++block) {
      if (!near[block]) continue;
      for (std::size_t i = block * kCodeBlock; i < (block + 1) * kCodeBlock; ++i) {
        if (start + i >= count_) return;  // the padding of the last batch
        best.offer(static_cast<std::uint32_t>(start + i), static_cast<std::uint32_t>(squared[i]));
      }
    }
  }

  DescriptorTable rows_;
  std::size_t count_;
  ScanOptions options_;
  Pca pca_;
  float scale_ = 1;
  std::vector<std::int8_t> codes_;  // whole batches of blocks, see code_distance.h
  std::vector<std::int32_t> norms_;
};

}  // namespace

std::unique_ptr<Search> make_scan_search(const Database& database, const ScanOptions& options) {
  return std::make_unique<ScanSearch>(database, options);
}

}  // namespace graspdb
