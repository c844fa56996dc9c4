// SPDX-License-Identifier: MIT
// Pictures and masks beside them.
#include "graspdb/video/frame_source.h"

#include <OpenImageIO/imagebuf.h>
#include <gmock/gmock.h>

#include "graspdb/core/error.h"
#include "graspdb/renderer/image_io.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::SizeIs;

// 32 x 16 as stored, 16 x 32 as shown.
void write_turned(const fs::path& file) {
  OIIO::ImageSpec spec(32, 16, 3, OIIO::TypeDesc::UINT8);
  spec["Orientation"] = 6;
  OIIO::ImageBuf image(spec);
  ASSERT_TRUE(image.write(file.string())) << image.geterror();
}

class Frames : public ::testing::Test {
 protected:
  fs::path path(const std::string& name) const { return directory_ / name; }

  // The mask of `levels`, a pixel each, as it is read beside a picture of that size.
  template <typename Level>
  Mask mask_of(const std::vector<int>& levels) const {
    Image<Level> stored(static_cast<int>(levels.size()), 1);
    std::transform(levels.begin(), levels.end(), stored.begin(),
                   [](int level) { return static_cast<Level>(level); });
    if constexpr (sizeof(Level) == 1) write_png(path("mask.png"), stored);
    if constexpr (sizeof(Level) == 2) write_png16(path("mask.png"), stored);
    return read_mask(path("mask.png"), ColorImage(stored.width(), 1));
  }
  template <typename Level = std::uint8_t>
  std::vector<int> inside(const std::vector<int>& levels) const {
    const Mask mask = mask_of<Level>(levels);
    std::vector<int> result;
    for (const std::uint8_t pixel : mask) result.push_back(pixel / 255);
    return result;
  }
  template <typename Level = std::uint8_t>
  void expect_refused(const std::vector<int>& levels) const {
    try {
      mask_of<Level>(levels);
      ADD_FAILURE() << ::testing::PrintToString(levels) << " was read";
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("mask.png"));
    }
  }

  testing::TemporaryDirectory directory_;
};

TEST_F(Frames, PhotographsAreUprightInAFolderAndAlone) {
  fs::create_directories(path("frames"));
  fs::create_directories(path("masks"));
  write_turned(path("frames/a.jpg"));
  write_png(path("frames/b.png"), ColorImage(16, 32));
  for (const char* mask : {"masks/a.png", "masks/b.png"}) write_png(path(mask), Mask(16, 32, 1));
  const auto folder = open_source(path("frames"), path("masks"));
  for (const std::size_t notes : {1, 0}) {
    const auto frame = folder->next();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->color.width(), 16);
    EXPECT_EQ(frame->mask, Mask(16, 32, 255));
    EXPECT_THAT(frame->notes, SizeIs(notes));
  }
  const auto alone = open_source(path("frames/a.jpg"), {});
  EXPECT_EQ(alone->next()->color.width(), 16);
  EXPECT_FALSE(alone->next());
}

TEST_F(Frames, NamesTellPhotographsFromFrames) {
  const auto unrelated = [&](const std::vector<std::string>& names) {
    fs::remove_all(path("named"));
    fs::create_directories(path("named"));
    for (const std::string& name : names) write_png(path("named/" + name), ColorImage(4, 4));
    return open_source(path("named"), {})->unrelated();
  };
  EXPECT_FALSE(unrelated({"frame9.png", "frame10.png", "frame11.png"}));
  EXPECT_FALSE(unrelated({"000000.png", "000001.png"}));
  EXPECT_TRUE(unrelated({"000000.png", "000002.png"}));
  EXPECT_TRUE(unrelated({"a1.png", "b2.png"}));
  EXPECT_TRUE(unrelated({"cat.png", "dog.png"}));
  EXPECT_TRUE(unrelated({"frame1.png"}));
  EXPECT_TRUE(unrelated({"1.png", "99999999999999999999999999.png"}));
}

TEST_F(Frames, APhotographStatesItsFocalLength) {
  OIIO::ImageSpec spec(36, 24, 3, OIIO::TypeDesc::UINT8);
  spec["Exif:FocalLengthIn35mmFilm"] = 50;
  OIIO::ImageBuf image(spec);
  ASSERT_TRUE(image.write(path("a.jpg").string())) << image.geterror();
  EXPECT_DOUBLE_EQ(open_source(path("a.jpg"), {})->next()->focal_px, 50);
  write_png(path("b.png"), ColorImage(4, 4));
  EXPECT_EQ(open_source(path("b.png"), {})->next()->focal_px, 0);
}

TEST_F(Frames, AMaskOfWhatIsStoredDoesNotFitWhatIsShown) {
  fs::create_directories(path("frames"));
  write_turned(path("frames/a.jpg"));
  write_png(path("a.png"), Mask(32, 16, 255));
  try {
    open_source(path("frames"), directory_.path())->next();
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("a mask of 16 x 32 pixels"));
    EXPECT_THAT(error.what(), HasSubstr("a.png"));
  }
}

TEST_F(Frames, OfTwoLevelsTheBrighterIsHand) {
  const std::vector<int> expected = {0, 1, 1, 0};
  for (const int hand : {1, 7, 38, 100, 128, 255}) EXPECT_EQ(inside({0, hand, hand, 0}), expected);
  for (const int hand : {1, 255, 257, 65535})
    EXPECT_EQ(inside<std::uint16_t>({0, hand, hand, 0}), expected) << hand;
}

TEST_F(Frames, OfLabelsTheHandsIsHand) {
  const std::vector<int> expected = {0, 1, 0, 1};
  EXPECT_EQ(inside({0, 1, 2, 1}), expected);
  EXPECT_EQ(inside<std::uint16_t>({0, 1, 2, 1}), expected);
}

TEST_F(Frames, ASoftMaskIsCutAtHalf) {
  EXPECT_EQ(inside({0, 3, 60, 120, 135, 250, 255, 251}),
            (std::vector<int>{0, 0, 0, 0, 1, 1, 1, 1}));
  EXPECT_EQ(inside<std::uint16_t>({0, 9, 30000, 33000, 65535, 65000}),
            (std::vector<int>{0, 0, 0, 1, 1, 1}));
}

TEST_F(Frames, ABlackMaskIsNoHandAndAWhiteOneAllHand) {
  EXPECT_EQ(inside({0, 0}), (std::vector<int>{0, 0}));
  EXPECT_EQ(inside({255, 255}), (std::vector<int>{1, 1}));
  EXPECT_EQ(inside({1, 1}), (std::vector<int>{1, 1}));
}

TEST_F(Frames, LevelsThatCouldBeAnythingAreRefused) {
  expect_refused({0, 0, 2, 2});                  // only objects
  expect_refused({0, 1, 2, 3, 4});               // parts
  expect_refused({0, 38, 75, 0});                // labels in colours
  expect_refused({0, 20, 40, 60, 80, 100});      // too dark
  expect_refused({0, 100, 110, 120, 130, 255});  // a photograph
  expect_refused<std::uint16_t>({0, 200, 255});  // 8 bits in 16
}

TEST_F(Frames, AMaskInTheAlphaOnlyIsRefused) {
  OIIO::ImageBuf image(OIIO::ImageSpec(2, 1, 4, OIIO::TypeDesc::UINT8));
  image.setpixel(0, 0, {0, 0, 0, 1.0F});
  image.setpixel(1, 0, {0, 0, 0, 0});
  image.write(path("mask.png").string());
  EXPECT_THROW(read_mask(path("mask.png"), ColorImage(2, 1)), Error);
}

}  // namespace
}  // namespace graspdb
