// SPDX-License-Identifier: MIT
#include "glb_accessors.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "reduced_files.h"

namespace graspdb {
namespace {

using nlohmann::json;

const std::map<std::string, std::size_t> kWidths = {
    {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
const std::map<std::size_t, std::size_t> kBytes = {
    {kUnsignedByte, 1}, {kUnsignedShort, 2}, {kUnsignedInt, 4}, {kFloat, 4}};

void require_small(const JsonEntry& accessor, const GlbElements& elements, std::size_t width) {
  for (std::size_t i = 0; i < elements.count * width; ++i) {
    const float number = elements.at<float>(i / width, i % width);
    if (std::abs(number) <= kLargestCoordinate) continue;
    accessor.refuse(fmt::format("numbers up to {:g}", kLargestCoordinate),
                    fmt::format("{} in element {}", number, i / width));
  }
}

// Of elements of `size` bytes: how far they are apart, and that all of them are there.
void measure(const JsonEntry& accessor, std::size_t size, GlbElements& elements) {
  if (elements.stride == 0) elements.stride = size;
  if (elements.stride < size) {
    accessor.refuse(fmt::format("a stride of {} bytes or more", size),
                    fmt::format("{}", elements.stride));
  }
  const std::size_t room = elements.bytes.size();
  const std::size_t most = room < size ? 0 : (room - size) / elements.stride + 1;
  elements.count = accessor.at("count").whole(most + 1);
  if (elements.count == 0) accessor.at("count").refuse("more than 0");
}

}  // namespace

std::size_t GlbElements::index_at(std::size_t element) const {
  if (component == kUnsignedByte) return at<std::uint8_t>(element);
  if (component == kUnsignedShort) return at<std::uint16_t>(element);
  return at<std::uint32_t>(element);
}

GlbAccessors::GlbAccessors(const JsonEntry& root, std::string_view binary)
    : all_(root.items("accessors")),
      views_(root.items("bufferViews")),
      binary_(binary),
      used_(all_.size(), json::object()),
      used_views_(views_.size(), json::object()) {}

std::string_view GlbAccessors::use_view(const JsonEntry& user) {
  const std::size_t index = user.whole(views_.size());
  const JsonEntry& view = views_[index];
  if (view.at("buffer").whole() != 0) view.at("buffer").refuse("0, the file's own");
  const std::size_t offset = view.whole_or("byteOffset", 0, binary_.size() + 1);
  const std::size_t length = view.at("byteLength").whole(binary_.size() - offset + 1);
  used_views_[index] = {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", length}};
  if (view.has("byteStride")) used_views_[index]["byteStride"] = view.at("byteStride").whole(256);
  return binary_.substr(offset, length);
}

GlbElements GlbAccessors::use(const JsonEntry& user, const GlbKind& kind) {
  const std::size_t index = user.whole(all_.size());
  const JsonEntry& entry = all_[index];
  if (entry.has("sparse")) entry.at("sparse").refuse("no such entry", "one");
  const std::string type = entry.at("type").one_of(kind.types);
  const std::size_t component = entry.at("componentType").one_of(kind.components);
  const std::size_t width = kWidths.at(type);
  const JsonEntry view = entry.at("bufferView");
  const std::string_view bytes = use_view(view);
  const std::size_t offset = entry.whole_or("byteOffset", 0, bytes.size() + 1);
  GlbElements elements{.accessor = index,
                       .component = component,
                       .stride = views_[view.whole()].whole_or("byteStride", 0, 256),
                       .bytes = bytes.substr(offset)};
  measure(entry, width * kBytes.at(component), elements);
  if (component == kFloat) require_small(entry, elements, width);
  used_[index] = {{"bufferView", view.whole()},
                  {"byteOffset", offset},
                  {"componentType", component},
                  {"count", elements.count},
                  {"type", type}};
  return elements;
}

}  // namespace graspdb
