// SPDX-License-Identifier: MIT
#include "graspdb/features/hog.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "features/pictures.h"
#include "graspdb/core/error.h"

namespace graspdb {
namespace {

using ::testing::Each;
using ::testing::HasSubstr;
using testing::Picture;
using testing::random_picture;

TEST(TightBox, HoldsTheOutermostPixels) {
  Mask mask(40, 30);
  EXPECT_FALSE(tight_box(mask));
  mask.at(0, 29) = 1;
  EXPECT_EQ(tight_box(mask), (Box{0, 29, 1, 1}));
  mask.at(39, 3) = 255;
  EXPECT_EQ(tight_box(mask), (Box{0, 3, 40, 27}));
}

TEST(HogName, EveryModeComesBackAndOthersAreRefusedByName) {
  for (const HogMode mode : {HogMode::kPaper, HogMode::kSoftEdges}) {
    EXPECT_EQ(hog_from_name(hog_name(mode), "a file"), mode);
  }
  try {
    hog_from_name("papier", "some.db");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("some.db"));
    EXPECT_THAT(error.what(), HasSubstr("papier"));
  }
}

class EveryMode : public ::testing::TestWithParam<HogMode> {
 protected:
  Descriptor describe_picture(const Picture& picture) {
    return describe(picture.gray, picture.mask, {GetParam()});
  }
};

TEST_P(EveryMode, AnEmptyMaskGivesZeros) {
  EXPECT_THAT(describe(GrayImage(20, 20, 77), Mask(20, 20), {GetParam()}), Each(0));
}

TEST_P(EveryMode, WhatIsOutsideTheMaskDoesNotMatter) {
  const Picture picture = random_picture(3, 70, 50, 6);
  Picture other = picture;
  for (std::size_t i = 0; i < other.gray.size(); ++i) {
    if (other.mask.data()[i] == 0) other.gray.data()[i] = 250;
  }
  EXPECT_EQ(describe_picture(picture), describe_picture(other));
}

TEST_P(EveryMode, WhereTheBoxLiesInThePictureDoesNotMatter) {
  EXPECT_EQ(describe_picture(random_picture(4, 61, 47, 0)).size(), 512U);
  const Picture inner = random_picture(4, 61, 47, 9);
  Picture touching{GrayImage(61, 47), Mask(61, 47)};
  for (int y = 0; y < 47; ++y) {
    std::copy_n(inner.gray.row(y + 9) + 9, 61, touching.gray.row(y));
    std::copy_n(inner.mask.row(y + 9) + 9, 61, touching.mask.row(y));
  }
  EXPECT_EQ(describe_picture(inner), describe_picture(touching));
}

TEST_P(EveryMode, SinglePixelsAndThinLinesAreDescribed) {
  for (const auto& [width, height] : {std::pair(1, 1), {1, 40}, {40, 1}, {3, 5}, {7, 9}}) {
    const Descriptor descriptor =
        describe(GrayImage(width, height, 200), Mask(width, height, 255), {GetParam()});
    EXPECT_GT(*std::max_element(descriptor.begin(), descriptor.end()), 0) << width << 'x' << height;
  }
}

INSTANTIATE_TEST_SUITE_P(Hog, EveryMode, ::testing::Values(HogMode::kPaper, HogMode::kSoftEdges),
                         [](const auto& instance) {
                           return instance.param == HogMode::kPaper ? "paper" : "edges";
                         });

}  // namespace
}  // namespace graspdb
