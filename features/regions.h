// SPDX-License-Identifier: MIT
// The connected regions (of 8 neighbours) of a mask.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "graspdb/core/image.h"

namespace graspdb {

struct Region {
  int area_px = 0;
  Box box;
};

// Between their nearest sides or corners; 0 when they overlap.
double gap_between(const Box& a, const Box& b);

// Found as runs of pixels: runs of neighbouring rows that touch are joined.
class Regions {
 public:
  explicit Regions(const Mask& mask);

  const std::vector<Region>& all() const { return regions_; }  // in the order of their first pixels
  // Of those with at least min_area_px pixels, of which one or more lie in `roi`, when given.
  std::optional<std::size_t> largest(int min_area_px, const std::optional<Box>& roi) const;
  // Sets the region's pixels to 255. `mask` is of the size of the one that was looked at.
  void paint(std::size_t region, Mask& mask) const;

 private:
  struct Run {
    int y, begin, end;  // begin <= x < end
    std::size_t region;
  };
  void add_row(const std::uint8_t* row, int y, int left, int right);
  void join_rows(std::size_t above, std::size_t here);
  std::size_t root(std::size_t run);
  void number_regions();
  bool reaches(std::size_t region, const Box& box) const;

  std::vector<Run> runs_;
  std::vector<std::size_t> parent_;
  std::vector<Region> regions_;
};

}  // namespace graspdb
