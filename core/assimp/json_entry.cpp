// SPDX-License-Identifier: MIT
#include "json_entry.h"

#include <fmt/format.h>

#include <cmath>

#include "graspdb/core/error.h"
#include "reduced_files.h"

namespace graspdb {
namespace {

constexpr std::size_t kLongestList = 100000;
constexpr std::size_t kLongestText = 1000;

}  // namespace

void JsonEntry::refuse(const std::string& expected, const std::string& found) const {
  throw Error({file_, place_, expected, found});
}

void JsonEntry::refuse(const std::string& expected) const {
  const bool is_short = !value_->is_structured() && !value_->is_string();
  refuse(expected, is_short ? value_->dump() : value_->type_name());
}

JsonEntry JsonEntry::at(const std::string& name) const {
  const std::string place = place_.empty() ? name : place_ + "." + name;
  if (!has(name)) throw Error({file_, place, "an entry", "none"});
  return {(*value_)[name], file_, place};
}

std::vector<JsonEntry> JsonEntry::items() const {
  if (!value_->is_array()) refuse("a list");
  if (value_->size() > kLongestList) {
    refuse(fmt::format("at most {} entries", kLongestList), fmt::format("{}", value_->size()));
  }
  std::vector<JsonEntry> items;
  for (const nlohmann::json& item : *value_) {
    items.emplace_back(item, file_, fmt::format("{}[{}]", place_, items.size()));
  }
  return items;
}

std::vector<JsonEntry> JsonEntry::items(const std::string& name) const {
  return has(name) ? at(name).items() : std::vector<JsonEntry>();
}

std::size_t JsonEntry::whole(std::size_t limit) const {
  const bool is_whole = value_->is_number_unsigned();
  if (!is_whole || value_->get<std::uint64_t>() >= limit) {
    refuse(fmt::format("a whole number below {}", limit));
  }
  return value_->get<std::size_t>();
}

std::size_t JsonEntry::whole_or(const std::string& name, std::size_t otherwise,
                                std::size_t limit) const {
  return has(name) ? at(name).whole(limit) : otherwise;
}

std::string JsonEntry::text() const {
  const std::string_view text = long_text();
  if (text.size() > kLongestText) refuse(fmt::format("at most {} bytes", kLongestText), "more");
  return std::string(text);
}

std::string_view JsonEntry::long_text() const {
  if (!value_->is_string()) refuse("a text");
  return value_->get_ref<const std::string&>();
}

bool JsonEntry::flag(const std::string& name) const {
  if (!has(name)) return false;
  const JsonEntry entry = at(name);
  if (!entry.value_->is_boolean()) entry.refuse("true or false");
  return entry.value_->get<bool>();
}

std::vector<double> JsonEntry::numbers(std::size_t size) const {
  const auto is_small = [](const nlohmann::json& item) {
    return item.is_number() && std::abs(item.get<double>()) <= kLargestCoordinate;
  };
  if (!value_->is_array() || value_->size() != size || !std::ranges::all_of(*value_, is_small)) {
    refuse(fmt::format("{} numbers up to {:g}", size, kLargestCoordinate));
  }
  return value_->get<std::vector<double>>();
}

}  // namespace graspdb
