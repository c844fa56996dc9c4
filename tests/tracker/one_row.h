// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "graspdb/database/search.h"

namespace graspdb::testing {

// Knows one row only.
class OneRow : public Search {
 public:
  OneRow(const Database& database, std::uint32_t row) : database_(database), row_(row) {}
  std::vector<Neighbor> nearest(DescriptorView query, int /*k*/) const override {
    return measure(database_, query, std::span(&row_, 1));
  }

 private:
  const Database& database_;
  std::uint32_t row_;
};

}  // namespace graspdb::testing
