// SPDX-License-Identifier: MIT
#include "lsh.h"

#include <algorithm>
#include <bit>

#include "distance.h"
#include "exact.h"
#include "graspdb/core/error.h"
#include "lsh_probes.h"
#include "top_k.h"

namespace graspdb {
namespace {

// Finds the rows of a key. Keys are scrambled, hence spread evenly: their first bits lead to within
// a key or two of the right one.
class Bucketed {
 public:
  explicit Bucketed(LshTable table) : table_(std::move(table)) {
    const int bits = std::max(1, static_cast<int>(std::bit_width(table_.keys.size())));
    shift_ = 64 - bits;
    first_.resize((std::size_t{1} << bits) + 1);
    std::size_t key = 0;
    for (std::size_t i = 0; i + 1 < first_.size(); ++i) {
      while (key < table_.keys.size() && table_.keys[key] >> shift_ < i) ++key;
      first_[i] = static_cast<std::uint32_t>(key);
    }
    first_.back() = static_cast<std::uint32_t>(table_.keys.size());
  }

  std::span<const std::uint32_t> rows(std::uint64_t key) const {
    const std::size_t start = key >> shift_;
    for (std::size_t i = first_[start]; i < first_[start + 1]; ++i) {
      if (table_.keys[i] != key) continue;
      return std::span(table_.rows)
          .subspan(table_.starts[i], table_.starts[i + 1] - table_.starts[i]);
    }
    return {};
  }

 private:
  LshTable table_;
  int shift_ = 0;
  std::vector<std::uint32_t> first_;  // of the keys that start with these bits
};

// A set of rows; they come out ascending, which is how memory likes to be read.
class RowSet {
 public:
  explicit RowSet(std::size_t rows) : words_(rows / 64 + 1) {}
  void add(std::uint32_t row) { words_[row / 64] |= std::uint64_t{1} << row % 64; }

  std::vector<std::uint32_t> rows() const {
    std::vector<std::uint32_t> rows;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      for (std::uint64_t left = words_[i]; left != 0; left &= left - 1) {
        rows.push_back(static_cast<std::uint32_t>(i * 64) +
                       static_cast<std::uint32_t>(std::countr_zero(left)));
      }
    }
    return rows;
  }

 private:
  std::vector<std::uint64_t> words_;
};

class LshSearch : public Search {
 public:
  LshSearch(const Database& database, LshIndex index)
      : rows_(database.descriptors()),
        options_(index.options),
        hash_(index.options, index.cell, rows_.size) {
    for (LshTable& table : index.tables) tables_.emplace_back(std::move(table));
  }

  std::vector<Neighbor> nearest(DescriptorView query, int k) const override {
    GRASPDB_CHECK(k >= 0);
    const std::vector<std::uint32_t> rows = candidates(query);
    if (rows.size() < static_cast<std::size_t>(k)) return exact_nearest(rows_, query, k);
    std::vector<std::uint32_t> squared(rows.size());
    squared_distances(query, rows_.bytes.data(), rows, squared);
    TopK best(static_cast<std::size_t>(k));
    for (std::size_t i = 0; i < rows.size(); ++i) best.offer(rows[i], squared[i]);
    return best.take();
  }

 private:
  std::vector<std::uint32_t> candidates(DescriptorView query) const {
    RowSet found(rows_.rows());
    const Eigen::MatrixXf projected = hash_.project(query);
    const auto functions = static_cast<std::size_t>(options_.hashes);
    for (std::size_t table = 0; table < tables_.size(); ++table) {
      probe(table, {projected.data() + table * functions, functions}, found);
    }
    return found.rows();
  }

  void probe(std::size_t table, std::span<const float> projected, RowSet& found) const {
    const std::uint64_t home = hash_.sum(table, projected);
    ProbeSequence sequence(projected);
    std::uint64_t set = 0;
    for (int i = 0; i < options_.probes && sequence.next(set); ++i) {
      std::uint64_t sum = home;
      for (std::uint64_t left = set; left != 0; left &= left - 1) {
        const Step& step = sequence.steps()[static_cast<std::size_t>(std::countr_zero(left))];
        const std::uint64_t weight = hash_.weight(table, step.function);
        sum += step.direction > 0 ? weight : -weight;
      }
      for (const std::uint32_t row : tables_[table].rows(LshHash::key(sum))) found.add(row);
    }
  }

  DescriptorTable rows_;
  LshOptions options_;
  LshHash hash_;
  std::vector<Bucketed> tables_;
};

}  // namespace

std::unique_ptr<Search> make_lsh_search(const Database& database, const LshOptions& options) {
  return std::make_unique<LshSearch>(database, build_lsh_index(database, options));
}

}  // namespace graspdb
