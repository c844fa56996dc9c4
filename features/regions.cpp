// SPDX-License-Identifier: MIT
// Connected regions from runs of pixels: runs of neighbouring rows that touch are joined.
#include <algorithm>
#include <numeric>

#include "graspdb/error.h"
#include "graspdb/segmentation.h"

namespace graspdb {
namespace {

struct Run {
  int y, begin, end;  // begin <= x < end
};

class Regions {
 public:
  explicit Regions(const Mask& mask);

  const std::vector<Run>& runs() const { return runs_; }
  std::size_t root(std::size_t run);

 private:
  void add_row(const Mask& mask, int y);
  void join_rows(std::size_t above, std::size_t here);

  std::vector<Run> runs_;
  std::vector<std::size_t> parent_;
};

Regions::Regions(const Mask& mask) {
  std::size_t above = 0;
  for (int y = 0; y < mask.height(); ++y) {
    const std::size_t here = runs_.size();
    add_row(mask, y);
    join_rows(above, here);
    above = here;
  }
}

void Regions::add_row(const Mask& mask, int y) {
  const std::uint8_t* row = mask.row(y);
  const std::uint8_t* end = row + mask.width();
  const auto inside = [](std::uint8_t pixel) { return pixel != 0; };
  for (const std::uint8_t* x = row;;) {
    const std::uint8_t* first = std::find_if(x, end, inside);
    if (first == end) return;
    x = std::find_if_not(first, end, inside);
    parent_.push_back(runs_.size());
    runs_.push_back({y, static_cast<int>(first - row), static_cast<int>(x - row)});
  }
}

// The rows' runs start at `above` and `here`; the latter's are the last.
void Regions::join_rows(std::size_t above, std::size_t here) {
  const std::size_t end = runs_.size();
  for (std::size_t a = above, b = here; a < here && b < end;) {
    const bool touch = runs_[a].begin <= runs_[b].end && runs_[b].begin <= runs_[a].end;
    if (touch) parent_[root(b)] = root(a);
    if (runs_[a].end < runs_[b].end) {
      ++a;
    } else {
      ++b;
    }
  }
}

std::size_t Regions::root(std::size_t run) {
  while (parent_[run] != run) run = parent_[run] = parent_[parent_[run]];
  return run;
}

bool overlaps(const Run& run, const Box& box) {
  return run.y >= box.y && run.y < box.y + box.height && run.begin < box.x + box.width &&
         run.end > box.x;
}

}  // namespace

std::optional<Mask> largest_region(const Mask& mask, int min_area_px,
                                   const std::optional<Box>& roi) {
  GRASPDB_CHECK(min_area_px >= 0);
  Regions regions(mask);
  const std::vector<Run>& runs = regions.runs();
  std::vector<int> area(runs.size());
  std::vector<bool> in_roi(runs.size(), !roi.has_value());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::size_t root = regions.root(i);
    area[root] += runs[i].end - runs[i].begin;
    if (roi && overlaps(runs[i], *roi)) in_roi[root] = true;
  }
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!in_roi[i]) area[i] = 0;
  }
  const auto largest = std::max_element(area.begin(), area.end());
  if (largest == area.end() || *largest < std::max(min_area_px, 1)) return std::nullopt;
  const auto chosen = static_cast<std::size_t>(largest - area.begin());
  Mask region(mask.width(), mask.height());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (regions.root(i) != chosen) continue;
    std::fill(region.row(runs[i].y) + runs[i].begin, region.row(runs[i].y) + runs[i].end,
              std::uint8_t{255});
  }
  return region;
}

}  // namespace graspdb
