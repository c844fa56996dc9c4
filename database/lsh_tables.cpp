// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "graspdb/core/error.h"
#include "graspdb/core/parallel.h"
#include "graspdb/core/random.h"
#include "lsh.h"

namespace graspdb {
namespace {

constexpr std::size_t kBlock = 512;  // rows projected at once

void check_range(const char* option, double low, double high, double found) {
  if (found >= low && found <= high) return;
  throw Error({.key = option,
               .expected = fmt::format("{} to {}", low, high),
               .found = fmt::format("{}", found)});
}

// The median, over rows spread evenly, of the distance to the 20th nearest other row.
double typical_distance(const Database& database) {
  constexpr std::size_t kSample = 100;
  constexpr int kNeighbor = 20;
  const std::size_t count = std::min(kSample, database.rows());
  if (count == 0) return 1;
  const std::unique_ptr<Search> exact = make_exact_search(database);
  std::vector<double> distances(count);
  parallel_for(count, 0, [&](std::size_t i) {
    const DescriptorView row = database.descriptors().row(i * database.rows() / count);
    const std::uint32_t squared = exact->nearest(row, kNeighbor + 1).back().squared_distance;
    distances[i] = std::sqrt(static_cast<double>(squared));
  });
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return std::max(*middle, 1.0);  // 0 when most rows are duplicates
}

// keys[table][row]
std::vector<std::vector<std::uint64_t>> all_keys(const Database& database, const LshHash& hash,
                                                 const LshOptions& options) {
  const std::size_t rows = database.rows();
  const auto functions = static_cast<std::size_t>(options.hashes);
  std::vector keys(static_cast<std::size_t>(options.tables), std::vector<std::uint64_t>(rows));
  parallel_for((rows + kBlock - 1) / kBlock, 0, [&](std::size_t block) {
    const std::size_t start = block * kBlock, size = std::min(kBlock, rows - start);
    const auto& [bytes, bytes_each] = database.descriptors();
    const Eigen::MatrixXf projected =
        hash.project(bytes.subspan(start * bytes_each, size * bytes_each));
    for (std::size_t i = 0; i < size; ++i) {
      const float* column = projected.col(static_cast<Eigen::Index>(i)).data();
      for (std::size_t table = 0; table < keys.size(); ++table) {
        keys[table][start + i] =
            LshHash::key(hash.sum(table, {column + table * functions, functions}));
      }
    }
  });
  return keys;
}

LshTable make_table(const std::vector<std::uint64_t>& keys) {
  LshTable table;
  table.rows.resize(keys.size());
  std::iota(table.rows.begin(), table.rows.end(), 0U);
  std::ranges::stable_sort(table.rows, {}, [&](std::uint32_t row) { return keys[row]; });
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const std::uint64_t key = keys[table.rows[i]];
    if (!table.keys.empty() && table.keys.back() == key) continue;
    table.keys.push_back(key);
    table.starts.push_back(static_cast<std::uint32_t>(i));
  }
  table.starts.push_back(static_cast<std::uint32_t>(keys.size()));
  return table;
}

void check_options(const LshOptions& options) {
  check_range("tables", 1, 1000, options.tables);
  check_range("hashes", 1, 32, options.hashes);
  check_range("width", 1e-3, 1e3, options.width);
  check_range("probes", 1, 1e6, options.probes);
}

}  // namespace

LshHash::LshHash(const LshOptions& options, double cell, std::size_t descriptor_size)
    : functions_(static_cast<std::size_t>(options.hashes)),
      directions_(options.tables * options.hashes, static_cast<Eigen::Index>(descriptor_size)),
      shifts_(options.tables * options.hashes) {
  for (int function = 0; function < directions_.rows(); ++function) {
    RandomStream random(options.seed, static_cast<std::uint64_t>(function));
    for (float& value : directions_.row(function)) {
      value = static_cast<float>(random.normal() / cell);
    }
    shifts_[function] = static_cast<float>(random.uniform());
    weights_.push_back(random.bits() | 1);
  }
}

Eigen::MatrixXf LshHash::project(DescriptorView descriptors) const {
  using Bytes = Eigen::Matrix<std::uint8_t, Eigen::Dynamic, Eigen::Dynamic>;
  const Eigen::Map<const Bytes> bytes(
      descriptors.data(), directions_.cols(),
      static_cast<Eigen::Index>(descriptors.size()) / directions_.cols());
  Eigen::MatrixXf projected = directions_ * bytes.cast<float>();
  projected.colwise() += shifts_;
  return projected;
}

std::uint64_t LshHash::sum(std::size_t table, std::span<const float> projected) const {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < projected.size(); ++i) {
    const auto cell = static_cast<std::int64_t>(std::floor(projected[i]));
    sum += static_cast<std::uint64_t>(cell) * weight(table, i);
  }
  return sum;
}

std::uint64_t LshHash::key(std::uint64_t sum) {
  sum = (sum ^ (sum >> 32)) * 0x9E3779B97F4A7C15ULL;
  return (sum ^ (sum >> 29)) * 0xBF58476D1CE4E5B9ULL;
}

LshIndex build_lsh_index(const Database& database, const LshOptions& options) {
  check_options(options);
  LshIndex index{.options = options,
                 .cell = options.width * typical_distance(database),
                 .tables = std::vector<LshTable>(static_cast<std::size_t>(options.tables))};
  const auto keys =
      all_keys(database, LshHash(options, index.cell, database.descriptors().size), options);
  parallel_for(keys.size(), 0, [&](std::size_t i) { index.tables[i] = make_table(keys[i]); });
  return index;
}

}  // namespace graspdb
