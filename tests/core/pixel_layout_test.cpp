// SPDX-License-Identifier: MIT
#include "graspdb/core/pixel_layout.h"

#include <gmock/gmock.h>

#include <cmath>

#include "graspdb/core/error.h"

namespace graspdb {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using Levels = Image<std::uint16_t>;

// 1 2 3
// 4 5 6
Levels two_rows() {
  Levels image(3, 2);
  std::uint16_t next = 0;
  for (std::uint16_t& level : image) level = ++next;
  return image;
}

std::vector<int> levels_of(const Levels& image) {
  return {image.begin(), image.end()};
}

// As EXIF defines them by where the stored first row and first column lie in the picture.
TEST(PixelLayout, EveryOrientationIsShownUpright) {
  const auto shown = [](int orientation) {
    return levels_of(as_shown(two_rows(), {.orientation = orientation}));
  };
  EXPECT_THAT(shown(1), ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_THAT(shown(2), ElementsAre(3, 2, 1, 6, 5, 4));  // row 0 top, column 0 right
  EXPECT_THAT(shown(3), ElementsAre(6, 5, 4, 3, 2, 1));  // bottom, right
  EXPECT_THAT(shown(4), ElementsAre(4, 5, 6, 1, 2, 3));  // bottom, left
  EXPECT_THAT(shown(5), ElementsAre(1, 4, 2, 5, 3, 6));  // left, top
  EXPECT_THAT(shown(6), ElementsAre(4, 1, 5, 2, 6, 3));  // right, top
  EXPECT_THAT(shown(7), ElementsAre(6, 3, 5, 2, 4, 1));  // right, bottom
  EXPECT_THAT(shown(8), ElementsAre(3, 6, 2, 5, 1, 4));  // left, bottom
  EXPECT_EQ(as_shown(two_rows(), {.orientation = 6}).width(), 2);
  EXPECT_EQ(as_shown(two_rows(), {.orientation = 6}).height(), 3);
}

TEST(PixelLayout, WidePixelsWidenThePictureAndHighOnesHeightenIt) {
  EXPECT_THAT(levels_of(as_shown(two_rows(), {.aspect = 2})),
              ElementsAre(1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6));
  EXPECT_THAT(levels_of(as_shown(two_rows(), {.aspect = 0.5})),
              ElementsAre(1, 2, 3, 1, 2, 3, 4, 5, 6, 4, 5, 6));
}

// The aspect is that of the stored pixels: they are wide before the picture is turned.
TEST(PixelLayout, PixelsAreMadeSquareBeforeThePictureIsTurned) {
  const Levels shown = as_shown(two_rows(), {.orientation = 8, .aspect = 2});
  EXPECT_EQ(shown.width(), 2);
  EXPECT_EQ(shown.height(), 6);
}

TEST(PixelLayout, ColorsBetweenPixelsAreMixed) {
  ColorImage image(2, 1);
  image.at(1, 0) = {100, 200, 40};
  const ColorImage shown = as_shown(image, {.aspect = 2});
  ASSERT_EQ(shown.width(), 4);
  EXPECT_EQ(shown.at(1, 0), (Bgr{25, 50, 10}));
  EXPECT_EQ(shown.at(3, 0), (Bgr{100, 200, 40}));
}

TEST(PixelLayout, WhatAFileStatesIsCleanedOrRefused) {
  EXPECT_EQ(checked_layout(0, 0, "a.jpg"), PixelLayout{});
  EXPECT_EQ(checked_layout(9, NAN, "a.jpg"), PixelLayout{});
  EXPECT_EQ(checked_layout(6, 300.0 / 299, "a.jpg"), (PixelLayout{.orientation = 6}));
  EXPECT_EQ(checked_layout(1, 16.0 / 15, "a.jpg").aspect, 16.0 / 15);
  try {
    checked_layout(1, 1e6, "a.jpg");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("a.jpg"));
  }
}

TEST(PixelLayout, WhatWasDoneIsSaid) {
  EXPECT_THAT(notes_on({}, "EXIF"), IsEmpty());
  EXPECT_THAT(notes_on({.orientation = 6, .aspect = 2}, "EXIF orientation 6"),
              ElementsAre("turned clockwise by 90 degrees (EXIF orientation 6)",
                          HasSubstr("2 times as wide as high")));
}

}  // namespace
}  // namespace graspdb
