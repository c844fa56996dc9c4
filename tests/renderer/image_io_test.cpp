// SPDX-License-Identifier: MIT
#include "graspdb/renderer/image_io.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/random.h"
#include "support/quarters.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;
using testing::corners_of;
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

// Red, green over blue, white: what is stored when a viewer is to turn it by `orientation`.
void write_stored(const fs::path& file, int orientation, float aspect = 1) {
  OIIO::ImageSpec spec(32, 16, 3, OIIO::TypeDesc::UINT8);
  spec["Orientation"] = orientation;
  spec["PixelAspectRatio"] = aspect;
  spec["XResolution"] = 72.0F;
  spec["YResolution"] = 72.0F * aspect;
  spec["ResolutionUnit"] = "in";
  OIIO::ImageBuf image(spec);
  const float quarters[][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 32; ++x) image.setpixel(x, y, quarters[2 * (y / 8) + x / 16]);
  }
  ASSERT_TRUE(image.write(file.string())) << image.geterror();
}

TEST(ImageIo, EveryExifOrientationIsApplied) {
  const TemporaryDirectory folder;
  const std::array<const char*, 8> expected = {"rgbw", "grwb", "wbgr", "bwrg",
                                               "rbgw", "brwg", "wgbr", "gwrb"};
  for (int orientation = 1; orientation <= 8; ++orientation) {
    for (const char* ending : {".jpg", ".tif"}) {
      const fs::path file = folder / fmt::format("a{}{}", orientation, ending);
      write_stored(file, orientation);
      const Picture picture = read_picture(file);
      EXPECT_EQ(corners_of(picture.color), expected.at(orientation - 1)) << file;
      EXPECT_EQ(picture.color.width(), orientation < 5 ? 32 : 16) << file;
      EXPECT_EQ(picture.notes.size(), orientation == 1 ? 0 : 1) << file;
      EXPECT_EQ(read_gray(file).width(), picture.color.width()) << file;
      EXPECT_EQ(read_levels(file).gray.width(), picture.color.width()) << file;
    }
  }
}

// As the PNG specification has it, bit by bit.
std::uint32_t crc(const std::string& bytes) {
  std::uint32_t sum = ~0U;
  for (const char byte : bytes) {
    sum ^= static_cast<std::uint8_t>(byte);
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1) ^ ((sum & 1) != 0 ? 0xEDB88320U : 0);
  }
  return ~sum;
}

std::string big_endian(std::uint32_t number) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift);
  return bytes;
}

// After the signature and the header of 25 bytes.
void add_exif(const fs::path& png, const std::string& exif) {
  std::string bytes = read_text(png);
  const std::string chunk = "eXIf" + exif;
  bytes.insert(
      33, big_endian(static_cast<std::uint32_t>(exif.size())) + chunk + big_endian(crc(chunk)));
  write_text(png, bytes);
}

TEST(ImageIo, TheOrientationOfAPngIsApplied) {
  using namespace std::string_literals;
  const TemporaryDirectory folder;
  const std::string little = "II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0\0\0\0\0"s,
                    big = "MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0"s;
  for (const std::string& exif : {little, big}) {
    write_stored(folder / "a.png", 1);
    add_exif(folder / "a.png", exif);
    EXPECT_EQ(corners_of(read_color(folder / "a.png")), "brwg");
  }
  for (std::size_t size = 0; size < little.size() - 4; ++size) {  // cut short: there is none
    write_stored(folder / "a.png", 1);
    add_exif(folder / "a.png", little.substr(0, size));
    EXPECT_EQ(read_color(folder / "a.png").width(), size < 20 ? 32 : 16) << size;
  }
}

TEST(ImageIo, TheOrientationOfAWebpIsApplied) {
  using namespace std::string_literals;
  const TemporaryDirectory folder;
  write_stored(folder / "a.webp", 1);
  std::string bytes = read_text(folder / "a.webp");
  const std::string exif = "MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0"s;
  bytes += "EXIF"s + static_cast<char>(exif.size()) + "\0\0\0"s + exif;
  const auto size = static_cast<std::uint32_t>(bytes.size() - 8);
  for (std::size_t i = 0; i < 4; ++i) bytes[4 + i] = static_cast<char>(size >> (8 * i));
  write_text(folder / "a.webp", bytes);
  EXPECT_EQ(corners_of(read_color(folder / "a.webp")), "brwg");
}

TEST(ImageIo, PixelsAreMadeSquare) {
  const TemporaryDirectory folder;
  for (const char* name : {"a.png", "a.jpg", "a.tif"}) {
    write_stored(folder / name, 1, 2);
    const Picture wide = read_picture(folder / name);
    EXPECT_EQ(wide.color.width(), 64) << name;
    EXPECT_EQ(wide.color.height(), 16) << name;
    EXPECT_EQ(corners_of(wide.color), "rgbw") << name;
    EXPECT_THAT(wide.notes, ::testing::ElementsAre(HasSubstr("square pixels"))) << name;
    write_stored(folder / name, 1, 0.5F);
    EXPECT_EQ(read_color(folder / name).height(), 32) << name;
  }
  write_stored(folder / "long.png", 1, 40);
  EXPECT_THROW(read_color(folder / "long.png"), Error);
}

TEST(ImageIo, AJpegThatEndsEarlyIsRefused) {
  const TemporaryDirectory folder;
  for (const int progressive : {0, 1}) {
    OIIO::ImageBuf image(OIIO::ImageSpec(64, 64, 3, OIIO::TypeDesc::UINT8));
    OIIO::ImageBufAlgo::noise(image, "uniform", 0, 1);
    image.specmod()["jpeg:progressive"] = progressive;
    image.write((folder / "whole.jpg").string());
    EXPECT_EQ(read_color(folder / "whole.jpg").width(), 64);
    const std::string whole = read_text(folder / "whole.jpg");
    for (const std::size_t percent : {30, 50, 80, 99}) {
      write_text(folder / "half.jpg", whole.substr(0, whole.size() * percent / 100));
      EXPECT_THROW(read_color(folder / "half.jpg"), Error) << percent;
      EXPECT_THROW(read_levels(folder / "half.jpg"), Error) << percent;
    }
  }
}

// libpng would make room for what the chunk says: 1.9 GB.
TEST(ImageIo, APngWithAChunkBeyondItsEndIsRefused) {
  const TemporaryDirectory folder;
  write_png(folder / "whole.png", GrayImage(4, 4));
  const std::string whole = read_text(folder / "whole.png");
  const std::size_t after_header = 8 + 12 + 13;
  for (const std::string length : {"\x70\x78\x7f\x03", "\x7f\xff\xff\xff"}) {
    std::string hostile = whole;
    hostile.insert(after_header, length + "tEXta");
    write_text(folder / "hostile.png", hostile);
    try {
      read_color(folder / "hostile.png");
      ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("ends early"));
    }
  }
  write_text(folder / "half.png", whole.substr(0, whole.size() - 20));
  EXPECT_THROW(read_gray(folder / "half.png"), Error);
  write_text(folder / "more.png",
             whole + "\x7f\xff\xff\xffmore");  // after the end anything may stand
  EXPECT_EQ(read_gray(folder / "more.png").width(), 4);
}

TEST(ImageIo, WhatIsTransparentIsBlackAndSaid) {
  const TemporaryDirectory folder;
  OIIO::ImageBuf image(OIIO::ImageSpec(2, 1, 4, OIIO::TypeDesc::UINT8));
  image.specmod()["oiio:UnassociatedAlpha"] = 1;
  image.setpixel(0, 0, {1.0F, 0.5F, 0.25F, 1.0F});
  image.setpixel(1, 0, {0, 0, 0, 0});
  image.write((folder / "a.png").string());
  Picture picture = read_picture(folder / "a.png");
  EXPECT_EQ(picture.color.at(0, 0), (Bgr{64, 128, 255}));
  EXPECT_EQ(picture.color.at(1, 0), (Bgr{0, 0, 0}));
  EXPECT_THAT(picture.notes, ::testing::ElementsAre(HasSubstr("transparent")));
  image.setpixel(1, 0, {0, 0, 0, 1.0F});
  image.write((folder / "opaque.png").string());
  EXPECT_TRUE(read_picture(folder / "opaque.png").notes.empty());
}

TEST(ImageIo, LevelsAreThoseOfTheFile) {
  const TemporaryDirectory folder;
  GrayImage labels(3, 1);
  labels.at(1, 0) = 1;
  labels.at(2, 0) = 2;
  write_png(folder / "a.png", labels);
  Image<std::uint16_t> deep(3, 1);
  deep.at(1, 0) = 1;
  deep.at(2, 0) = 65535;
  write_png16(folder / "deep.png", deep);
  const Levels levels = read_levels(folder / "a.png"),
               deep_levels = read_levels(folder / "deep.png");
  EXPECT_TRUE(std::equal(labels.begin(), labels.end(), levels.gray.begin()));
  EXPECT_EQ(levels.white, 255);
  EXPECT_EQ(deep_levels.gray, deep);
  EXPECT_EQ(deep_levels.white, 65535);
  EXPECT_EQ(read_color(folder / "deep.png").at(2, 0), (Bgr{255, 255, 255}));
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
