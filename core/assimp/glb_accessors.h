// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "json_entry.h"

namespace graspdb {

// Numbers of the glTF specification.
enum GlbComponent : std::size_t {
  kUnsignedByte = 5121,
  kUnsignedShort = 5123,
  kUnsignedInt = 5125,
  kFloat = 5126
};

// What an accessor must be to stand in its place.
struct GlbKind {
  std::vector<std::string> types;
  std::vector<std::size_t> components;
};

// Elements in the binary chunk, all of them inside it.
struct GlbElements {
  std::size_t accessor, component, stride, count = 0;
  std::string_view bytes;  // from the first one on

  template <typename T>
  T at(std::size_t element, std::size_t column = 0) const {
    T value;
    std::memcpy(&value, bytes.data() + element * stride + column * sizeof(T), sizeof(T));
    return value;
  }
  std::size_t index_at(std::size_t element) const;  // of those that are one whole number each
};

// The accessors and buffer views of a .glb: what is used of them is checked, the rest is emptied.
class GlbAccessors {
 public:
  // Keeps references to both.
  GlbAccessors(const JsonEntry& root, std::string_view binary);

  // Checks the accessor that `user` is the index of. Floats are finite and up to
  // kLargestCoordinate.
  GlbElements use(const JsonEntry& user, const GlbKind& kind);

  nlohmann::json used() const { return used_; }
  nlohmann::json used_views() const { return used_views_; }

 private:
  std::string_view use_view(const JsonEntry& user);

  std::vector<JsonEntry> all_, views_;
  std::string_view binary_;
  nlohmann::json::array_t used_, used_views_;
};

}  // namespace graspdb
