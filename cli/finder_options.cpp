// SPDX-License-Identifier: MIT
#include "finder_options.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

#include "checks.h"
#include "graspdb/core/error.h"

namespace graspdb::cli {
namespace {

constexpr int kMaxSide = 100000;  // of a picture, pixels

using NamedRule = std::pair<std::string_view, SkinRule>;
constexpr std::array<NamedRule, 2> kSkinRules = {
    {{"redness", SkinRule::kRedness}, {"box", SkinRule::kBox}}};

bool is_file(const std::string& finder) {
  return finder.ends_with(".safetensors");
}

bool is_there(const std::filesystem::path& file) {
  std::error_code too_long;  // of a name
  return std::filesystem::exists(file, too_long);
}

// A check of CLI11: an empty answer says that all is well.
std::string check_finder(const std::string& finder) {
  if (std::ranges::find(kSkinRules, finder, &NamedRule::first) != kSkinRules.end()) return "";
  if (is_file(finder) || is_there(finder_file(finder))) return "";
  return finder +
         ": neither redness nor box, nor the name or the file (.safetensors) of a learned finder";
}

}  // namespace

std::optional<Box> FinderSettings::box() const {
  if (roi.empty()) return std::nullopt;
  return Box{roi[0], roi[1], roi[2], roi[3]};
}

FinderOptions FinderSettings::options(bool looks_for_hands) const {
  if (!looks_for_hands) return {};
  const auto known = std::ranges::find(kSkinRules, finder, &NamedRule::first);
  if (known != kSkinRules.end()) return {.net = nullptr, .skin = {.rule = known->second}};
  const auto file = is_file(finder) ? std::filesystem::path(finder) : finder_file(finder);
  return {.net = std::make_shared<HandFinder>(HandFinder::load(file))};
}

CLI::Option* add_finder_option(CLI::App& verb, FinderSettings& settings) {
  return verb
      .add_option(
          "--finder", settings.finder,
          "How hands are found: hand, the net that comes with graspdb; another net's file of "
          "weights (.safetensors); redness, by colour, with a threshold that follows the frame; "
          "box, by "
          "colour, the paper's box in HSV")
      ->check(check_finder)
      ->default_str(settings.finder);
}

void add_still_option(CLI::App& verb, bool& still) {
  verb.add_flag("--still", still,
                "Frames are photographs that have nothing to do with each other; a picture alone, "
                "or a folder of some that are not numbered one after the other, always are");
}

void add_roi_option(CLI::App& verb, FinderSettings& settings) {
  verb.add_option("--roi", settings.roi, "Only hands that reach into this box: x,y,w,h in pixels")
      ->delimiter(',')
      ->expected(4)
      ->check(range(-kMaxSide, kMaxSide));
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
