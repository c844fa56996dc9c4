// SPDX-License-Identifier: MIT
#include "graspdb/core/pixel_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "graspdb/core/error.h"

namespace graspdb {
namespace {

constexpr double kNearlySquare = 0.01;  // resolutions are rounded to whole numbers
constexpr double kLongestPixel = 4;

Bgr between(const Bgr& a, const Bgr& b, double share_of_b) {
  Bgr mixed;
  for (std::size_t i = 0; i < mixed.size(); ++i)
    mixed[i] = static_cast<std::uint8_t>(std::lround(a[i] + share_of_b * (b[i] - a[i])));
  return mixed;
}

// Between two labels there is no third one.
std::uint16_t between(std::uint16_t a, std::uint16_t b, double share_of_b) {
  return share_of_b < 0.5 ? a : b;
}

template <typename T>
Image<T> widened(const Image<T>& stored, double factor) {
  Image<T> wide(static_cast<int>(std::lround(stored.width() * factor)), stored.height());
  const double last = stored.width() - 1;
  for (int x = 0; x < wide.width(); ++x) {
    const double u = std::clamp((x + 0.5) * stored.width() / wide.width() - 0.5, 0.0, last);
    const int left = static_cast<int>(u), right = std::min(left + 1, stored.width() - 1);
    for (int y = 0; y < wide.height(); ++y)
      wide.at(x, y) = between(stored.at(left, y), stored.at(right, y), u - left);
  }
  return wide;
}

// EXIF's numbers: from 5 on rows and columns are exchanged; then either may run backwards.
template <typename T>
Image<T> turned(const Image<T>& stored, int orientation) {
  const bool exchanged = orientation >= 5;
  const bool columns_back = orientation == 2 || orientation == 3 || orientation >= 7;
  const bool rows_back =
      orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
  Image<T> shown(exchanged ? stored.height() : stored.width(),
                 exchanged ? stored.width() : stored.height());
  for (int y = 0; y < shown.height(); ++y) {
    for (int x = 0; x < shown.width(); ++x) {
      const int u = exchanged ? y : x, v = exchanged ? x : y;
      shown.at(x, y) = stored.at(columns_back ? stored.width() - 1 - u : u,
                                 rows_back ? stored.height() - 1 - v : v);
    }
  }
  return shown;
}

template <typename T>
Image<T> laid_out(Image<T> image, const PixelLayout& layout) {
  constexpr int kExchange = 5;
  if (layout.aspect > 1) image = widened(image, layout.aspect);
  if (layout.aspect < 1)
    image = turned(widened(turned(image, kExchange), 1 / layout.aspect), kExchange);
  return layout.orientation == 1 ? image : turned(image, layout.orientation);
}

const char* turn_of(int orientation) {
  constexpr std::array kTurns = {"",
                                 "mirrored",
                                 "turned by 180 degrees",
                                 "mirrored upside down",
                                 "mirrored and turned counterclockwise by 90 degrees",
                                 "turned clockwise by 90 degrees",
                                 "mirrored and turned clockwise by 90 degrees",
                                 "turned counterclockwise by 90 degrees"};
  return kTurns.at(static_cast<std::size_t>(orientation - 1));
}

}  // namespace

PixelLayout checked_layout(int orientation, double aspect, const std::string& file) {
  PixelLayout layout;
  if (orientation >= 1 && orientation <= 8) layout.orientation = orientation;
  if (!(aspect > 0) || std::abs(aspect - 1) <= kNearlySquare) return layout;
  layout.aspect = aspect;
  if (aspect <= kLongestPixel && aspect >= 1 / kLongestPixel) return layout;
  throw Error({file, "pixel aspect ratio",
               fmt::format("{0} at most, 1/{0} at least", kLongestPixel),
               fmt::format("{}", aspect)});
}

ColorImage as_shown(ColorImage stored, const PixelLayout& layout) {
  return laid_out(std::move(stored), layout);
}

Image<std::uint16_t> as_shown(Image<std::uint16_t> stored, const PixelLayout& layout) {
  return laid_out(std::move(stored), layout);
}

std::vector<std::string> notes_on(const PixelLayout& layout, const std::string& source) {
  std::vector<std::string> notes;
  if (layout.orientation != 1)
    notes.push_back(fmt::format("{} ({})", turn_of(layout.orientation), source));
  if (layout.aspect != 1) {
    notes.push_back(fmt::format(
        "scaled to square pixels (stored ones are {:.4g} times as wide as high)", layout.aspect));
  }
  return notes;
}

}  // namespace graspdb
