// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "gltf_buffers.h"
#include "json_entry.h"

namespace graspdb {

// Numbers of the glTF specification.
enum GltfComponent : std::size_t {
  kByte = 5120,
  kUnsignedByte = 5121,
  kShort = 5122,
  kUnsignedShort = 5123,
  kUnsignedInt = 5125,
  kFloat = 5126
};

// What an accessor must be to stand in its place, and what its numbers become.
struct GltfKind {
  std::vector<std::string> types;
  std::vector<std::size_t> components;
  GltfComponent written;
  bool are_shares = false;  // whole numbers mean shares of 1, also where `normalized` is missing
};

// An accessor of the written file.
struct GltfNumbers {
  std::size_t accessor, count;
  double largest;
};

// The numbers of a glTF file that are used, checked and written anew one accessor after the other:
// without strides, gaps, sparse changes and quantization.
class GltfAccessors {
 public:
  // Keeps references to both.
  GltfAccessors(const JsonEntry& root, GltfBuffers& buffers);

  // Checks the accessor that `user` is the index of and writes it, once for each kind of numbers.
  // All are finite and up to kLargestCoordinate, indices up to 2^32.
  GltfNumbers use(const JsonEntry& user, const GltfKind& kind);
  std::size_t write_identities(std::size_t count);  // matrices; the accessor's index

  const nlohmann::json::array_t& written() const { return written_; }
  const nlohmann::json::array_t& written_views() const { return written_views_; }
  const std::string& binary() const { return binary_; }

 private:
  // Some elements of an accessor, all of them inside `bytes`.
  struct Elements {
    std::string_view bytes;
    std::size_t stride, component;
    double number(std::size_t element, std::size_t column) const;
  };

  std::vector<double> numbers_of(const JsonEntry& entry, std::size_t count, std::size_t width,
                                 std::size_t component);
  Elements elements(const JsonEntry& place, std::size_t component, std::size_t width,
                    std::size_t count);
  void change_sparsely(const JsonEntry& entry, std::size_t width, std::size_t component,
                       std::vector<double>& numbers);
  GltfNumbers write(const std::vector<double>& numbers, const std::string& type,
                    GltfComponent component);
  void write_number(double number, GltfComponent component);

  std::vector<JsonEntry> all_, views_;
  GltfBuffers& buffers_;
  std::map<std::tuple<std::size_t, GltfComponent, bool>, GltfNumbers> known_;
  nlohmann::json::array_t written_, written_views_;
  std::string binary_;
  std::size_t zeros_ = 0;
};

}  // namespace graspdb
