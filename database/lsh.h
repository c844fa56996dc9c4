// SPDX-License-Identifier: MIT
// Locality-sensitive hashing with p-stable distributions (Datar, Immorlica, Indyk, Mirrokni 2004):
// h(v) = floor(a.v / w + b), a normal, b uniform in [0, 1); a table's key is made of several h.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "graspdb/database/search.h"

namespace graspdb {

// The hash functions of all tables: a pure function of the options and the width of a cell.
class LshHash {
 public:
  // `cell` is w, in units of the u8 descriptors, which are of this size.
  LshHash(const LshOptions& options, double cell, std::size_t descriptor_size);

  // Column j holds a.v / w + b of descriptor j, for the functions of the first table, then of the
  // second, and so on. Descriptors lie one behind the other.
  Eigen::MatrixXf project(DescriptorView descriptors) const;

  // A key is a scrambled sum, so that the sum of a neighbouring cell needs one addition.
  std::uint64_t sum(std::size_t table, std::span<const float> projected) const;
  std::uint64_t weight(std::size_t table, std::size_t function) const {
    return weights_[table * functions_ + function];
  }
  static std::uint64_t key(std::uint64_t sum);

 private:
  std::size_t functions_;                                                             // a table
  Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> directions_;  // a / w
  Eigen::VectorXf shifts_;                                                            // b
  std::vector<std::uint64_t> weights_;
};

// The rows by key: those of keys[i] are rows[starts[i]] up to rows[starts[i + 1]].
struct LshTable {
  std::vector<std::uint64_t> keys;  // ascending, each once
  std::vector<std::uint32_t> starts;
  std::vector<std::uint32_t> rows;
};

struct LshIndex {
  LshOptions options;
  double cell = 1;
  std::vector<LshTable> tables;
};

// Throws Error naming the option that is out of range.
LshIndex build_lsh_index(const Database& database, const LshOptions& options);

}  // namespace graspdb
