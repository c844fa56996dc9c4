// SPDX-License-Identifier: MIT
#include "graspdb/renderer/image_io.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/pixel_layout.h"
#include "picture_chunks.h"

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

// As the file stores it, grey or colour with or without alpha.
template <typename Sample>
struct Decoded {
  OIIO::ImageSpec spec;
  std::vector<Sample> samples;
  PixelLayout layout;

  std::size_t channels() const { return static_cast<std::size_t>(spec.nchannels); }
  const Sample* at(std::size_t pixel) const { return samples.data() + pixel * channels(); }
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

PixelLayout layout_of(const OIIO::ImageSpec& spec, const fs::path& path) {
  const int stated = spec.get_int_attribute("Orientation", 0);
  return checked_layout(stated == 0 ? orientation_in_chunk(path) : stated,
                        spec.get_float_attribute("PixelAspectRatio", 1), path.string());
}

[[noreturn]] void fail_to_read(const fs::path& path, std::string found) {
  throw Error({.file = path.string(),
               .expected = "a whole picture",
               .found = found.empty() ? "a damaged one" : std::move(found)});
}

std::unique_ptr<OIIO::ImageInput> open_image(const fs::path& path) {
  if (is_png_with_a_chunk_beyond_its_end(path)) fail_to_read(path, "a PNG that ends early");
  auto input = OIIO::ImageInput::open(path.string());
  if (!input) fail_to_read(path, OIIO::geterror());
  return input;
}

// Samples are scaled to the type's range; colours are multiplied with alpha.
template <typename Sample>
Decoded<Sample> read_image(OIIO::ImageInput& input, const fs::path& path) {
  check_size(input.spec(), path);
  Decoded<Sample> decoded{input.spec(), {}, layout_of(input.spec(), path)};
  decoded.samples.resize(decoded.spec.image_pixels() * decoded.channels());
  const bool read = input.read_image(0, 0, 0, decoded.spec.nchannels,
                                     OIIO::BaseTypeFromC<Sample>::value, decoded.samples.data());
  // Of a JPEG that ends early the rest is grey, and the read has succeeded.
  if (!read || input.has_error()) fail_to_read(path, input.geterror());
  return decoded;
}

Decoded<std::uint8_t> read_8_bits(const fs::path& path) {
  return read_image<std::uint8_t>(*open_image(path), path);
}

// One or two channels are grey (and alpha), more are red, green, blue (and alpha).
template <typename Sample>
std::array<Sample, 3> bgr_at(const Decoded<Sample>& decoded, std::size_t pixel) {
  const Sample* sample = decoded.at(pixel);
  if (decoded.channels() < 3) return {sample[0], sample[0], sample[0]};
  return {sample[2], sample[1], sample[0]};
}

// Rec. 601 luma, as OpenCV computes grey.
template <typename Sample>
Sample luma(const std::array<Sample, 3>& bgr) {
  return static_cast<Sample>(std::lround(0.114 * bgr[0] + 0.587 * bgr[1] + 0.299 * bgr[2]));
}

ColorImage color_of(const Decoded<std::uint8_t>& decoded) {
  ColorImage image(decoded.spec.width, decoded.spec.height);
  for (std::size_t i = 0; i < image.size(); ++i) image.data()[i] = bgr_at(decoded, i);
  return as_shown(std::move(image), decoded.layout);
}

template <typename Sample>
Image<std::uint16_t> levels_of(const Decoded<Sample>& decoded) {
  Image<std::uint16_t> levels(decoded.spec.width, decoded.spec.height);
  for (std::size_t i = 0; i < levels.size(); ++i) levels.data()[i] = luma(bgr_at(decoded, i));
  return as_shown(std::move(levels), decoded.layout);
}

template <typename Sample>
bool is_transparent(const Decoded<Sample>& decoded) {
  const int alpha = decoded.spec.alpha_channel;
  if (alpha < 0) return false;
  for (std::size_t i = 0; i < decoded.spec.image_pixels(); ++i) {
    if (decoded.at(i)[alpha] != std::numeric_limits<Sample>::max()) return true;
  }
  return false;
}

template <typename Sample>
Levels read_levels(OIIO::ImageInput& input, const fs::path& path) {
  const auto decoded = read_image<Sample>(input, path);
  return {levels_of(decoded), std::numeric_limits<Sample>::max(), is_transparent(decoded)};
}

// EXIF has a whole number, of which 0 is unknown.
double focal_35mm(const OIIO::ImageSpec& spec) {
  const double focal = spec.get_float_attribute("Exif:FocalLengthIn35mmFilm", 0);
  return focal > 0 && std::isfinite(focal) ? focal : 0;
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

Picture read_picture(const fs::path& path) {
  const auto decoded = read_8_bits(path);
  Picture picture{
      color_of(decoded),
      notes_on(decoded.layout, fmt::format("EXIF orientation {}", decoded.layout.orientation))};
  picture.focal_35mm = focal_35mm(decoded.spec);
  if (is_transparent(decoded)) picture.notes.push_back("laid on black where it is transparent");
  return picture;
}

ColorImage read_color(const fs::path& path) {
  return color_of(read_8_bits(path));
}

GrayImage read_gray(const fs::path& path) {
  const auto levels = levels_of(read_8_bits(path));
  GrayImage image(levels.width(), levels.height());
  std::transform(levels.begin(), levels.end(), image.begin(),
                 [](std::uint16_t level) { return static_cast<std::uint8_t>(level); });
  return image;
}

Levels read_levels(const fs::path& path) {
  const auto input = open_image(path);
  return input->spec().format.size() > 1 ? read_levels<std::uint16_t>(*input, path)
                                         : read_levels<std::uint8_t>(*input, path);
}

}  // namespace graspdb
