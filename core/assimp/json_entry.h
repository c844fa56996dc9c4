// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace graspdb {

// A value inside a JSON file, and its place there for messages ("nodes[3].mesh"). Each getter
// throws Error for a value of another kind or beyond its limit. Keeps a reference to the value.
class JsonEntry {
 public:
  JsonEntry(const nlohmann::json& value, std::string file, std::string place = {})
      : value_(&value), file_(std::move(file)), place_(std::move(place)) {}

  bool has(const std::string& name) const { return value_->is_object() && value_->contains(name); }
  JsonEntry at(const std::string& name) const;                  // the member of an object
  std::vector<JsonEntry> items() const;                         // of a list of at most 100,000
  std::vector<JsonEntry> items(const std::string& name) const;  // none when there is no such list
  std::size_t whole(
      std::size_t limit = std::numeric_limits<std::size_t>::max()) const;  // 0 <= value < limit
  std::size_t whole_or(const std::string& name, std::size_t otherwise, std::size_t limit) const;
  std::string text() const;            // of at most 1000 bytes
  std::string_view long_text() const;  // of any length; lasts as long as the value
  bool is_zero() const { return *value_ == 0; }
  bool flag(const std::string& name) const;             // false when there is none
  std::vector<double> numbers(std::size_t size) const;  // up to kLargestCoordinate, either way

  template <typename T>
  T one_of(const std::vector<T>& choices) const {
    const auto known = std::find(choices.begin(), choices.end(), *value_);
    if (known == choices.end()) refuse("one of " + nlohmann::json(choices).dump());
    return *known;
  }

  [[noreturn]] void refuse(const std::string& expected) const;  // what was found is the value
  [[noreturn]] void refuse(const std::string& expected, const std::string& found) const;

 private:
  const nlohmann::json* value_;
  std::string file_, place_;
};

}  // namespace graspdb
