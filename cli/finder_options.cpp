// SPDX-License-Identifier: MIT
#include "finder_options.h"

#include <fmt/ranges.h>

#include "checks.h"
#include "graspdb/core/error.h"

namespace graspdb::cli {
namespace {

constexpr int kMaxSide = 100000;  // of a picture, pixels

}  // namespace

std::optional<Box> FinderSettings::box() const {
  if (roi.empty()) return std::nullopt;
  return Box{roi[0], roi[1], roi[2], roi[3]};
}

void add_finder_options(CLI::App& verb, FinderSettings& settings) {
  verb.add_option("--roi", settings.roi, "Only skin regions that touch this box: x,y,w,h in pixels")
      ->delimiter(',')
      ->expected(4)
      ->check(range(-kMaxSide, kMaxSide));
  verb.add_option("--skin", settings.skin.rule,
                  "redness: redder than the frame's own threshold; box: the paper's box in HSV")
      ->transform(named<SkinRule>({{"redness", SkinRule::kRedness}, {"box", SkinRule::kBox}}))
      ->default_str("redness");
}

void require_frames(const FrameSource& source, const std::string& input, std::size_t frames) {
  if (frames > 0) return;
  std::vector<std::string> found = source.warnings();
  found.insert(found.begin(), "none that can be read");
  throw Error({input, "", "frames", fmt::format("{}", fmt::join(found, "; "))});
}

void check(const FinderSettings& settings) {
  const std::optional<Box> box = settings.box();
  if (box && (box->width <= 0 || box->height <= 0))
    throw CLI::ValidationError("--roi", "width and height must be more than 0");
}

}  // namespace graspdb::cli
