// SPDX-License-Identifier: MIT
#include "graspdb/renderer/image_io.h"

#include <OpenImageIO/imagebuf.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/random.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::TemporaryDirectory;

template <typename Pixel, typename Draw>
Image<Pixel> random_image(int width, int height, Draw draw) {
  RandomStream random(7);
  Image<Pixel> image(width, height);
  for (Pixel& pixel : image) pixel = draw(random);
  return image;
}

std::uint8_t random_byte(RandomStream& random) {
  return static_cast<std::uint8_t>(random.below(256));
}

// What another program would read.
template <typename Sample>
std::vector<Sample> samples_of(const fs::path& path, OIIO::TypeDesc type) {
  const OIIO::ImageBuf buffer(path.string());
  std::vector<Sample> samples(buffer.spec().image_pixels() * buffer.spec().nchannels);
  EXPECT_TRUE(buffer.get_pixels(buffer.roi(), type, samples.data()));
  EXPECT_EQ(buffer.spec().format, type);
  return samples;
}

TEST(ImageIo, GrayPngComesBackPixelByPixel) {
  const TemporaryDirectory folder;
  const GrayImage image = random_image<std::uint8_t>(37, 21, random_byte);
  write_png(folder / "a.png", image);
  EXPECT_EQ(read_gray(folder / "a.png"), image);
  EXPECT_EQ(read_color(folder / "a.png").at(5, 6),
            (Bgr{image.at(5, 6), image.at(5, 6), image.at(5, 6)}));
}

TEST(ImageIo, ColorPngComesBackAndIsStoredAsRgb) {
  const TemporaryDirectory folder;
  const ColorImage image = random_image<Bgr>(19, 33, [](RandomStream& r) {
    return Bgr{random_byte(r), random_byte(r), random_byte(r)};
  });
  write_png(folder / "a.png", image);
  EXPECT_EQ(read_color(folder / "a.png"), image);
  const auto stored = samples_of<std::uint8_t>(folder / "a.png", OIIO::TypeDesc::UINT8);
  EXPECT_EQ(stored[0], image.at(0, 0)[2]);
  EXPECT_EQ(stored[2], image.at(0, 0)[0]);
}

TEST(ImageIo, ColorReadAsGrayIsItsLuma) {
  const TemporaryDirectory folder;
  write_png(folder / "a.png", ColorImage(2, 2, Bgr{10, 100, 200}));
  EXPECT_EQ(read_gray(folder / "a.png").at(1, 1), 120);  // 1.14 + 58.7 + 59.8 = 119.64
}

TEST(ImageIo, SixteenBitPngKeepsEveryBit) {
  const TemporaryDirectory folder;
  const auto image = random_image<std::uint16_t>(
      16, 9, [](RandomStream& r) { return static_cast<std::uint16_t>(r.below(65536)); });
  write_png16(folder / "a.png", image);
  const auto stored = samples_of<std::uint16_t>(folder / "a.png", OIIO::TypeDesc::UINT16);
  EXPECT_TRUE(std::equal(stored.begin(), stored.end(), image.begin(), image.end()));
}

TEST(ImageIo, ExrKeepsFloatsAndInfinity) {
  const TemporaryDirectory folder;
  auto image = random_image<float>(
      31, 17, [](RandomStream& r) { return static_cast<float>(r.uniform(0.3, 0.9)); });
  image.at(3, 4) = std::numeric_limits<float>::infinity();
  write_exr(folder / "z.exr", image);
  const auto stored = samples_of<float>(folder / "z.exr", OIIO::TypeDesc::FLOAT);
  EXPECT_TRUE(std::equal(stored.begin(), stored.end(), image.begin(), image.end()));
  EXPECT_EQ(OIIO::ImageBuf((folder / "z.exr").string()).spec().channelnames,
            std::vector<std::string>{"Z"});
}

TEST(ImageIo, ExrKeepsVectorsInTheirOrder) {
  const TemporaryDirectory folder;
  Image<Eigen::Vector3f> image(5, 4, Eigen::Vector3f(0.25F, -0.5F, 1.5F));
  image.at(4, 3) = {-1, 0, 1e-4F};
  write_exr(folder / "n.exr", image);
  const auto stored = samples_of<float>(folder / "n.exr", OIIO::TypeDesc::FLOAT);
  EXPECT_THAT(std::vector(stored.begin(), stored.begin() + 3),
              ::testing::ElementsAre(0.25F, -0.5F, 1.5F));
  EXPECT_THAT(std::vector(stored.end() - 3, stored.end()), ::testing::ElementsAre(-1, 0, 1e-4F));
  const std::vector<std::string> names = {"R", "G", "B"};
  EXPECT_EQ(OIIO::ImageBuf((folder / "n.exr").string()).spec().channelnames, names);
}

TEST(ImageIo, SamePictureSameBytesAndNothingElseInTheFolder) {
  const TemporaryDirectory folder;
  const auto depth = Image<float>(8, 8, 0.5F);
  write_exr(folder / "a.exr", depth);
  write_exr(folder / "b.exr", depth);
  EXPECT_EQ(read_text(folder / "a.exr"), read_text(folder / "b.exr"));
  EXPECT_THAT(read_text(folder / "a.exr"), HasSubstr("1970:01:01"));  // not the time of writing
  write_png(folder / "a.png", GrayImage(8, 8, 3));
  write_png(folder / "b.png", GrayImage(8, 8, 3));
  EXPECT_EQ(read_text(folder / "a.png"), read_text(folder / "b.png"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 4);
}

TEST(ImageIo, ErrorsNameTheFile) {
  const TemporaryDirectory folder;
  write_text(folder / "text.png", "no picture");
  write_png(folder / "whole.png", random_image<std::uint8_t>(64, 64, random_byte));
  // Damaged rather than cut, because OpenImageIO 2.4 leaks a string when a PNG ends early.
  std::string damaged = read_text(folder / "whole.png");
  damaged.replace(900, 100, 100, '\0');
  write_text(folder / "damaged.png", damaged);
  for (const char* name : {"absent.png", "text.png", "damaged.png"}) {
    try {
      read_gray(folder / name);
      ADD_FAILURE() << name << " was read";
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr(name));
    }
  }
  EXPECT_THROW(write_png("/proc/no/such/folder/a.png", GrayImage(2, 2)), Error);
}

TEST(ImageIo, CameraRotationInExifIsNotApplied) {
  const TemporaryDirectory folder;
  OIIO::ImageSpec spec(24, 16, 3, OIIO::TypeDesc::UINT8);
  spec["Orientation"] = 6;
  OIIO::ImageBuf(spec).write((folder / "turned.jpg").string());
  const ColorImage image = read_color(folder / "turned.jpg");
  EXPECT_EQ(image.width(), 24);
  EXPECT_EQ(image.height(), 16);
}

// The header of a PNG of 32768 pixels a side, and nothing behind it.
TEST(ImageIo, APictureThatSaysItIsHugeIsRefusedBeforeThereIsRoomForIt) {
  const TemporaryDirectory folder;
  write_text(
      folder / "a.png",
      std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x80\0\0\0\x80\0\x08\x02\0\0\0\x4b\x1e\x34\x28"
                  "\0\0\0\0IDAT\x35\xaf\x06\x1e",
                  45));
  try {
    read_color(folder / "a.png");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("at most 256 MiB"));
  }
}

}  // namespace
}  // namespace graspdb
