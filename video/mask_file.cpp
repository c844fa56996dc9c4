// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "graspdb/core/error.h"
#include "graspdb/renderer/image_io.h"
#include "graspdb/video/frame_source.h"

namespace graspdb {
namespace {

constexpr int kHandLabel = 1, kObjectLabel = 2;  // as `graspdb export` writes them

struct LevelRange {
  int low, high;
};

std::vector<std::size_t> count_levels(const Levels& levels) {
  std::vector<std::size_t> counts(static_cast<std::size_t>(levels.white) + 1);
  for (const std::uint16_t level : levels.gray) ++counts[level];
  return counts;
}

std::vector<int> levels_in(const std::vector<std::size_t>& counts) {
  std::vector<int> present;
  for (std::size_t level = 0; level < counts.size(); ++level) {
    if (counts[level] > 0) present.push_back(static_cast<int>(level));
  }
  return present;
}

// Black and white with soft edges, as compression or smoothing makes them.
bool is_soft_mask(const std::vector<std::size_t>& counts) {
  const auto quarter = static_cast<std::ptrdiff_t>(counts.size() / 4);
  const auto pixels = [&](std::ptrdiff_t from, std::ptrdiff_t to) {
    return std::accumulate(counts.begin() + from, counts.begin() + to, std::size_t{0});
  };
  const std::size_t between = pixels(quarter, 3 * quarter),
                    bright = pixels(3 * quarter, 4 * quarter);
  return bright > 0 && between <= bright;
}

// The levels that are hand; none when nothing says which.
std::optional<LevelRange> hand_levels(const Levels& levels) {
  const std::vector<std::size_t> counts = count_levels(levels);
  const std::vector<int> present = levels_in(counts);
  const int highest = present.back();
  if (highest == 0 && levels.transparent) return std::nullopt;  // the shape may be in the alpha
  if (highest == kObjectLabel) {
    const bool labels = counts[kHandLabel] > 0;
    return labels ? std::optional(LevelRange{kHandLabel, kHandLabel}) : std::nullopt;
  }
  const bool two_levels = highest == 1 || (present.size() == 2 && present.front() == 0);
  if (highest == 0 || two_levels) return LevelRange{std::max(highest, 1), levels.white};
  if (is_soft_mask(counts)) return LevelRange{levels.white / 2 + 1, levels.white};
  return std::nullopt;
}

std::string describe(const Levels& levels) {
  const std::vector<int> present = levels_in(count_levels(levels));
  return fmt::format("{} levels of grey, the brightest {} of {}{}", present.size(), present.back(),
                     levels.white, levels.transparent ? ", and transparency" : "");
}

}  // namespace

Mask read_mask(const std::filesystem::path& file, const ColorImage& color) {
  const Levels levels = read_levels(file);
  const Image<std::uint16_t>& gray = levels.gray;
  if (gray.width() != color.width() || gray.height() != color.height()) {
    throw Error({file.string(), "",
                 fmt::format("a mask of {} x {} pixels", color.width(), color.height()),
                 fmt::format("{} x {}", gray.width(), gray.height())});
  }
  const std::optional<LevelRange> hand = hand_levels(levels);
  if (!hand) {
    throw Error({file.string(), "",
                 "a mask: 0 and one other level, the labels 1 (hand) and 2 (object), or black and "
                 "white",
                 describe(levels)});
  }
  Mask mask(gray.width(), gray.height());
  std::transform(gray.begin(), gray.end(), mask.begin(), [&](std::uint16_t level) {
    return level >= hand->low && level <= hand->high ? 255 : 0;
  });
  return mask;
}

}  // namespace graspdb
