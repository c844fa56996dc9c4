// SPDX-License-Identifier: MIT
#include "graspdb/renderer/image_io.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"

namespace graspdb {

namespace fs = std::filesystem;

namespace {

// Encodes into memory, so that the file can be written aside whatever the format.
void write_image(const fs::path& path, const char* format, const OIIO::ImageSpec& spec,
                 const void* pixels) {
  std::vector<unsigned char> encoded;
  OIIO::Filesystem::IOVecOutput memory(encoded);
  const auto output = OIIO::ImageOutput::create(format, &memory);
  GRASPDB_CHECK(output != nullptr);
  if (!output->open(path.string(), spec) || !output->write_image(spec.format, pixels) ||
      !output->close()) {
    throw Error(path.string() + ": cannot encode the picture: " + output->geterror());
  }
  FileAside file(path);
  file.write(std::as_bytes(std::span(encoded)));
  file.commit();
}

template <typename Pixel>
OIIO::ImageSpec spec_of(const Image<Pixel>& image, int channels, OIIO::TypeDesc type) {
  GRASPDB_CHECK(!image.empty());
  return {image.width(), image.height(), channels, type};
}

OIIO::ImageSpec exr_spec(OIIO::ImageSpec spec) {
  spec["compression"] = "zip";
  spec["DateTime"] = "1970:01:01 00:00:00";  // else it is now, and no two files are the same
  return spec;
}

constexpr std::uint64_t kLargestPicture = 256 << 20;  // bytes, decoded

struct Decoded {
  int width, height, channels;
  std::vector<std::uint8_t> samples;
};

// A file of a few bytes can say that it has any size.
void check_size(const OIIO::ImageSpec& spec, const fs::path& path) {
  const auto channels = static_cast<std::uint64_t>(std::max(spec.nchannels, 0));
  if (channels > 0 && spec.image_pixels() <= kLargestPicture / channels) return;
  throw Error({.file = path.string(),
               .expected = fmt::format("at most {} MiB of samples", kLargestPicture >> 20),
               .found = fmt::format("{} x {} pixels of {} channels", spec.width, spec.height,
                                    spec.nchannels)});
}

Decoded read_image(const fs::path& path) {
  OIIO::ImageSpec config;
  config["oiio:UnassociatedAlpha"] = 1;  // colours as they are stored
  const auto input = OIIO::ImageInput::open(path.string(), &config);
  if (!input) {
    throw Error({.file = path.string(), .expected = "a picture", .found = OIIO::geterror()});
  }
  const OIIO::ImageSpec& spec = input->spec();
  check_size(spec, path);
  Decoded decoded{spec.width, spec.height, spec.nchannels, {}};
  decoded.samples.resize(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, decoded.samples.data())) {
    throw Error({.file = path.string(), .expected = "a picture", .found = input->geterror()});
  }
  return decoded;
}

// One or two channels are grey (and alpha), more are red, green, blue (and alpha).
Bgr bgr_at(const Decoded& decoded, std::size_t pixel) {
  const auto channels = static_cast<std::size_t>(decoded.channels);
  const std::uint8_t* sample = decoded.samples.data() + pixel * channels;
  if (channels < 3) return {sample[0], sample[0], sample[0]};
  return {sample[2], sample[1], sample[0]};
}

// Rec. 601 luma, as OpenCV computes grey.
std::uint8_t luma(const Bgr& bgr) {
  return static_cast<std::uint8_t>(std::lround(0.114 * bgr[0] + 0.587 * bgr[1] + 0.299 * bgr[2]));
}

}  // namespace

void write_png(const fs::path& path, const GrayImage& image) {
  write_image(path, "png", spec_of(image, 1, OIIO::TypeDesc::UINT8), image.data());
}

void write_png(const fs::path& path, const ColorImage& image) {
  std::vector<Bgr> rgb(image.begin(), image.end());
  for (Bgr& pixel : rgb) std::swap(pixel[0], pixel[2]);
  write_image(path, "png", spec_of(image, 3, OIIO::TypeDesc::UINT8), rgb.data());
}

void write_png16(const fs::path& path, const Image<std::uint16_t>& image) {
  write_image(path, "png", spec_of(image, 1, OIIO::TypeDesc::UINT16), image.data());
}

void write_exr(const fs::path& path, const Image<float>& image) {
  OIIO::ImageSpec spec = exr_spec(spec_of(image, 1, OIIO::TypeDesc::FLOAT));
  spec.channelnames = {"Z"};
  write_image(path, "openexr", spec, image.data());
}

void write_exr(const fs::path& path, const Image<Eigen::Vector3f>& image) {
  static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float));
  write_image(path, "openexr", exr_spec(spec_of(image, 3, OIIO::TypeDesc::FLOAT)), image.data());
}

GrayImage read_gray(const fs::path& path) {
  const Decoded decoded = read_image(path);
  GrayImage image(decoded.width, decoded.height);
  for (std::size_t i = 0; i < image.size(); ++i) image.data()[i] = luma(bgr_at(decoded, i));
  return image;
}

ColorImage read_color(const fs::path& path) {
  const Decoded decoded = read_image(path);
  ColorImage image(decoded.width, decoded.height);
  for (std::size_t i = 0; i < image.size(); ++i) image.data()[i] = bgr_at(decoded, i);
  return image;
}

}  // namespace graspdb
