// SPDX-License-Identifier: MIT
#include "gltf_accessors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "reduced_files.h"

namespace graspdb {
namespace {

using nlohmann::json;

// Accessors that share bytes, or have none besides sparse ones, say little and mean much.
constexpr std::size_t kMostNumbers = 1 << 25;  // of all that is written
constexpr std::size_t kMostZeros = 1 << 22;    // of all that have no bytes

const std::map<std::string, std::size_t> kWidths = {
    {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
const std::map<std::size_t, std::size_t> kBytes = {{kByte, 1},        {kUnsignedByte, 1},
                                                   {kShort, 2},       {kUnsignedShort, 2},
                                                   {kUnsignedInt, 4}, {kFloat, 4}};
// What stands for 1 among whole numbers that are shares.
const std::map<std::size_t, float> kWhole = {
    {kByte, 127}, {kUnsignedByte, 255}, {kShort, 32767}, {kUnsignedShort, 65535}};

template <typename T>
double number_at(const char* at) {
  T value;
  std::memcpy(&value, at, sizeof(value));
  return static_cast<double>(value);
}

template <typename T>
void append_number(double number, std::string& bytes) {
  const T value = static_cast<T>(number);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

void make_shares(std::size_t component, std::vector<double>& numbers) {
  const auto whole = kWhole.find(component);
  if (whole == kWhole.end()) return;
  for (double& number : numbers) {
    number = std::max(static_cast<float>(number) / whole->second, -1.0F);
  }
}

void require_small(const JsonEntry& accessor, const std::vector<double>& numbers,
                   std::size_t width) {
  const auto is_large = [](double number) { return !(std::abs(number) <= kLargestCoordinate); };
  const auto large = std::ranges::find_if(numbers, is_large);
  if (large == numbers.end()) return;
  accessor.refuse(fmt::format("numbers up to {:g}", kLargestCoordinate),
                  fmt::format("{} in element {}", *large,
                              static_cast<std::size_t>(large - numbers.begin()) / width));
}

}  // namespace

double GltfAccessors::Elements::number(std::size_t element, std::size_t column) const {
  const char* at = bytes.data() + element * stride + column * kBytes.at(component);
  switch (component) {
    case kByte:
      return number_at<std::int8_t>(at);
    case kUnsignedByte:
      return number_at<std::uint8_t>(at);
    case kShort:
      return number_at<std::int16_t>(at);
    case kUnsignedShort:
      return number_at<std::uint16_t>(at);
    case kUnsignedInt:
      return number_at<std::uint32_t>(at);
    default:
      return number_at<float>(at);
  }
}

GltfAccessors::GltfAccessors(const JsonEntry& root, GltfBuffers& buffers)
    : all_(root.items("accessors")), views_(root.items("bufferViews")), buffers_(buffers) {}

// `place` names a buffer view and where in it the first element is. `count` is known to be there
// only when this returns.
GltfAccessors::Elements GltfAccessors::elements(const JsonEntry& place, std::size_t component,
                                                std::size_t width, std::size_t count) {
  const JsonEntry& view = views_[place.at("bufferView").whole(views_.size())];
  const std::string_view buffer = buffers_.bytes(view.at("buffer"));
  const std::size_t start = view.whole_or("byteOffset", 0, buffer.size() + 1);
  const std::size_t length = view.at("byteLength").whole(buffer.size() - start + 1);
  const std::size_t offset = place.whole_or("byteOffset", 0, length + 1);
  const std::size_t size = width * kBytes.at(component), room = length - offset;
  const std::size_t stride = view.has("byteStride") ? view.at("byteStride").whole(256) : size;
  if (stride < size) {
    view.refuse(fmt::format("a stride of {} bytes or more", size), fmt::format("{}", stride));
  }
  const std::size_t most = room < size ? 0 : (room - size) / stride + 1;
  if (count > most) {
    place.refuse(fmt::format("at most {} elements, as its bytes have", most),
                 fmt::format("{}", count));
  }
  return {buffer.substr(start + offset, room), stride, component};
}

std::vector<double> GltfAccessors::numbers_of(const JsonEntry& entry, std::size_t count,
                                              std::size_t width, std::size_t component) {
  if (!entry.has("bufferView")) zeros_ += count * width;
  if (zeros_ > kMostZeros) {
    entry.at("count").refuse(fmt::format("at most {} numbers without bytes", kMostZeros));
  }
  std::vector<double> numbers(count * width, 0);
  if (entry.has("bufferView") || !entry.has("sparse")) {
    const Elements all = elements(entry, component, width, count);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      numbers[i] = all.number(i / width, i % width);
    }
  }
  if (entry.has("sparse")) change_sparsely(entry.at("sparse"), width, component, numbers);
  return numbers;
}

void GltfAccessors::change_sparsely(const JsonEntry& sparse, std::size_t width,
                                    std::size_t component, std::vector<double>& numbers) {
  const std::size_t count = sparse.at("count").whole(numbers.size() / width + 1);
  const JsonEntry places = sparse.at("indices");
  const std::size_t whole =
      places.at("componentType")
          .one_of(std::vector<std::size_t>{kUnsignedByte, kUnsignedShort, kUnsignedInt});
  const Elements indices = elements(places, whole, 1, count);
  const Elements values = elements(sparse.at("values"), component, width, count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto place = static_cast<std::size_t>(indices.number(i, 0));
    if (place >= numbers.size() / width) {
      places.refuse(fmt::format("elements below {}", numbers.size() / width),
                    fmt::format("{}", place));
    }
    for (std::size_t c = 0; c < width; ++c) numbers[place * width + c] = values.number(i, c);
  }
}

GltfNumbers GltfAccessors::use(const JsonEntry& user, const GltfKind& kind) {
  const std::size_t index = user.whole(all_.size());
  const JsonEntry& entry = all_[index];
  const std::string type = entry.at("type").one_of(kind.types);
  const std::size_t component = entry.at("componentType").one_of(kind.components);
  const auto key = std::tuple(index, kind.written, kind.are_shares);
  const auto known = known_.find(key);
  if (known != known_.end()) return known->second;
  const std::size_t width = kWidths.at(type);
  const std::size_t room = kMostNumbers - binary_.size() / sizeof(float);
  const std::size_t count = entry.at("count").whole(room / width + 1);
  if (count == 0) entry.at("count").refuse("more than 0");
  std::vector<double> numbers = numbers_of(entry, count, width, component);
  if (kind.are_shares || entry.flag("normalized")) make_shares(component, numbers);
  if (kind.written == kFloat) require_small(entry, numbers, width);
  const GltfNumbers written = write(numbers, type, kind.written);
  known_.emplace(key, written);
  return written;
}

std::size_t GltfAccessors::write_identities(std::size_t count) {
  std::vector<double> numbers(16 * count, 0);
  for (std::size_t i = 0; i < numbers.size(); i += i % 16 == 15 ? 1 : 5) numbers[i] = 1;
  return write(numbers, "MAT4", kFloat).accessor;
}

GltfNumbers GltfAccessors::write(const std::vector<double>& numbers, const std::string& type,
                                 GltfComponent component) {
  const std::size_t offset = binary_.size(), count = numbers.size() / kWidths.at(type);
  for (const double number : numbers) write_number(number, component);
  const std::size_t length = binary_.size() - offset;
  binary_.resize((binary_.size() + 3) / 4 * 4);
  written_.push_back({{"bufferView", written_views_.size()},
                      {"componentType", static_cast<std::size_t>(component)},
                      {"count", count},
                      {"type", type}});
  written_views_.push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", length}});
  return {written_.size() - 1, count, *std::ranges::max_element(numbers)};
}

void GltfAccessors::write_number(double number, GltfComponent component) {
  if (component == kFloat) {
    append_number<float>(number, binary_);
  } else if (component == kUnsignedShort) {
    append_number<std::uint16_t>(number, binary_);
  } else {
    append_number<std::uint32_t>(number, binary_);
  }
}

}  // namespace graspdb
