// SPDX-License-Identifier: MIT
#include "graspdb/core/json/strict_json.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "graspdb/core/error.h"

namespace graspdb {
namespace {

using nlohmann::json;

constexpr int kMaxDepth = 16;
constexpr int kMostPixels = 100'000;  // a side

// Told of every parse event; throws at the first fault, before anything of it is stored.
class Strictness {
 public:
  void see(int depth, json::parse_event_t event, const json& parsed) {
    if (depth > kMaxDepth) throw Error("nesting deeper than 16");
    if (event == json::parse_event_t::object_start) keys_.emplace_back();
    if (event == json::parse_event_t::object_end) keys_.pop_back();
    if (event != json::parse_event_t::key) return;
    const auto& name = parsed.get_ref<const std::string&>();
    if (!keys_.back().insert(name).second) throw Error("'" + name + "' twice");
  }

 private:
  std::vector<std::set<std::string>> keys_;  // of the objects that are open
};

}  // namespace

json parse_strict_json(std::string_view text, const std::string& file, const std::string& key) {
  const auto refuse = [&](const char* found) -> Error {
    return Error({.file = file, .key = key, .expected = "JSON", .found = found});
  };
  try {
    Strictness strictness;
    return json::parse(text, [&](int depth, json::parse_event_t event, json& parsed) {
      strictness.see(depth, event, parsed);
      return true;
    });
  } catch (const json::exception& fault) {
    throw refuse(fault.what());
  } catch (const Error& fault) {
    throw refuse(fault.what());
  }
}

JsonFields::JsonFields(const json& object, std::string file, std::string key)
    : object_(object), file_(std::move(file)), key_(std::move(key)) {
  if (object_.is_object()) return;
  throw Error({file_, key_, "an object", object_.type_name()});
}

std::string JsonFields::key_of(const std::string& name) const {
  return key_.empty() ? name : key_ + "." + name;
}

void JsonFields::refuse(const std::string& name, const std::string& expected,
                        const json& found) const {
  throw Error(
      {file_, key_of(name), expected, found.is_primitive() ? found.dump() : found.type_name()});
}

bool JsonFields::has(const std::string& name) const {
  return object_.contains(name);
}

const json& JsonFields::at(const std::string& name) const {
  const auto found = object_.find(name);
  if (found == object_.end()) throw Error({file_, key_of(name), "an entry", "none"});
  return *found;
}

JsonFields JsonFields::fields(const std::string& name) const {
  return JsonFields(at(name), file_, key_of(name));
}

std::string JsonFields::text(const std::string& name) const {
  const json& value = at(name);
  if (!value.is_string()) refuse(name, "a text", value);
  return value.get<std::string>();
}

int JsonFields::integer(const std::string& name, int low, int high) const {
  return integer(name, at(name), low, high);
}

int JsonFields::natural(const std::string& name) const {
  return integer(name, 0, std::numeric_limits<int>::max());
}

double JsonFields::number(const std::string& name) const {
  return number(name, at(name));
}

double JsonFields::positive(const std::string& name) const {
  const json& value = at(name);
  if (!value.is_number() || !(value > 0)) refuse(name, "a number above 0", value);
  return value.get<double>();
}

std::vector<double> JsonFields::numbers(const std::string& name, std::size_t count) const {
  return numbers(name, at(name), count);
}

std::vector<Eigen::Vector3d> JsonFields::points(const std::string& name, std::size_t count) const {
  const json& list = at(name);
  if (!list.is_array() || list.size() != count) {
    refuse(name, fmt::format("{} points", count), list);
  }
  std::vector<Eigen::Vector3d> points;
  for (const json& entry : list) {
    points.emplace_back(Eigen::Map<const Eigen::Vector3d>(numbers(name, entry, 3).data()));
  }
  return points;
}

json JsonFields::inner(const std::string& name) const {
  return parse_strict_json(text(name), file_, key_of(name));
}

int JsonFields::inner_natural(const std::string& name) const {
  return integer(name, inner(name), 0, std::numeric_limits<int>::max());
}

double JsonFields::inner_number(const std::string& name) const {
  return number(name, inner(name));
}

json JsonFields::inner_array(const std::string& name) const {
  json value = inner(name);
  if (!value.is_array()) refuse(name, "an array", value);
  return value;
}

int JsonFields::integer(const std::string& name, const json& value, int low, int high) const {
  // As a double: json compares what is above 2^63 as if it were negative.
  const double number = value.is_number_integer() ? value.get<double>() : std::nan("");
  if (!(number >= low && number <= high)) {
    refuse(name, fmt::format("a whole number from {} to {}", low, high), value);
  }
  return static_cast<int>(number);
}

double JsonFields::number(const std::string& name, const json& value) const {
  if (!value.is_number()) refuse(name, "a number", value);
  return value.get<double>();
}

std::vector<double> JsonFields::numbers(const std::string& name, const json& list,
                                        std::size_t count) const {
  const std::string expected = fmt::format("{} numbers", count);
  if (!list.is_array()) refuse(name, expected, list);
  if (list.size() != count) {
    throw Error({file_, key_of(name), expected, std::to_string(list.size())});
  }
  std::vector<double> values;
  for (const json& value : list) {
    if (!value.is_number()) refuse(name, expected, value);
    values.push_back(value.get<double>());
  }
  return values;
}

Intrinsics read_camera(const JsonFields& fields) {
  return {.width = fields.integer("width_px", 1, kMostPixels),
          .height = fields.integer("height_px", 1, kMostPixels),
          .fx = fields.positive("fx_px"),
          .fy = fields.positive("fy_px"),
          .cx = fields.number("cx_px"),
          .cy = fields.number("cy_px")};
}

}  // namespace graspdb
