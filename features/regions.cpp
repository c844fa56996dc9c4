// SPDX-License-Identifier: MIT
#include "regions.h"

#include <algorithm>
#include <cmath>

#include "graspdb/core/error.h"
#include "graspdb/features/hog.h"
#include "graspdb/features/segmentation.h"

namespace graspdb {

// Most of a mask is empty: only its box is gone through pixel by pixel.
Regions::Regions(const Mask& mask) {
  const Box box = tight_box(mask).value_or(Box{});
  std::size_t above = 0;
  for (int y = box.y; y < box.y + box.height; ++y) {
    const std::size_t here = runs_.size();
    add_row(mask.row(y), y, box.x, box.x + box.width);
    join_rows(above, here);
    above = here;
  }
  number_regions();
}

void Regions::add_row(const std::uint8_t* row, int y, int left, int right) {
  const std::uint8_t* end = row + right;
  const auto inside = [](std::uint8_t pixel) { return pixel != 0; };
  for (const std::uint8_t* x = row + left;;) {
    const std::uint8_t* first = std::find_if(x, end, inside);
    if (first == end) return;
    x = std::find_if_not(first, end, inside);
    parent_.push_back(runs_.size());
    runs_.push_back({y, static_cast<int>(first - row), static_cast<int>(x - row), 0});
  }
}

// The rows' runs start at `above` and `here`; the latter's are the last.
void Regions::join_rows(std::size_t above, std::size_t here) {
  const std::size_t end = runs_.size();
  for (std::size_t a = above, b = here; a < here && b < end;) {
    const bool touch = runs_[a].begin <= runs_[b].end && runs_[b].begin <= runs_[a].end;
    if (touch) {
      const std::size_t one = root(a), other = root(b);
      parent_[std::max(one, other)] = std::min(one, other);
    }
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

// A root is the first of its runs, so that it has its number before the others ask for it.
void Regions::number_regions() {
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    Run& run = runs_[i];
    const std::size_t first = root(i);
    run.region = first == i ? regions_.size() : runs_[first].region;
    if (first == i) regions_.push_back({0, {run.begin, run.y, 0, 0}});
    Region& region = regions_[run.region];
    region.area_px += run.end - run.begin;
    const int right = std::max(region.box.x + region.box.width, run.end);
    region.box.x = std::min(region.box.x, run.begin);
    region.box.width = right - region.box.x;
    region.box.height = run.y + 1 - region.box.y;
  }
}

bool Regions::reaches(std::size_t region, const Box& box) const {
  return std::any_of(runs_.begin(), runs_.end(), [&](const Run& run) {
    return run.region == region && run.y >= box.y && run.y < box.y + box.height &&
           run.begin < box.x + box.width && run.end > box.x;
  });
}

std::optional<std::size_t> Regions::largest(int min_area_px, const std::optional<Box>& roi) const {
  std::optional<std::size_t> largest;
  for (std::size_t i = 0; i < regions_.size(); ++i) {
    if (regions_[i].area_px < min_area_px) continue;
    if (largest && regions_[i].area_px <= regions_[*largest].area_px) continue;
    if (!roi || reaches(i, *roi)) largest = i;
  }
  return largest;
}

void Regions::paint(std::size_t region, Mask& mask) const {
  for (const Run& run : runs_) {
    if (run.region != region) continue;
    std::fill(mask.row(run.y) + run.begin, mask.row(run.y) + run.end, std::uint8_t{255});
  }
}

double gap_between(const Box& a, const Box& b) {
  const int x = std::max({0, a.x - b.x - b.width, b.x - a.x - a.width});
  const int y = std::max({0, a.y - b.y - b.height, b.y - a.y - a.height});
  return std::hypot(x, y);
}

std::optional<Mask> largest_region(const Mask& mask, int min_area_px,
                                   const std::optional<Box>& roi) {
  GRASPDB_CHECK(min_area_px >= 0);
  const Regions regions(mask);
  const auto largest = regions.largest(min_area_px, roi);
  if (!largest) return std::nullopt;
  Mask region(mask.width(), mask.height());
  regions.paint(*largest, region);
  return region;
}

}  // namespace graspdb
