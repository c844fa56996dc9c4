// SPDX-License-Identifier: MIT
#include "strict_json.h"

#include <limits>
#include <set>
#include <vector>

#include "refuse.h"

namespace graspdb {
namespace {

using nlohmann::json;

constexpr int kMaxDepth = 16;

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
  graspdb::refuse(file_, key_, "an object", object_.type_name());
}

void JsonFields::refuse(const std::string& name, const std::string& expected,
                        const json& found) const {
  graspdb::refuse(file_, key_ + "." + name, expected,
                  found.is_primitive() ? found.dump() : found.type_name());
}

bool JsonFields::has(const std::string& name) const {
  return object_.contains(name);
}

const json& JsonFields::at(const std::string& name) const {
  const auto found = object_.find(name);
  if (found == object_.end()) graspdb::refuse(file_, key_ + "." + name, "an entry", "none");
  return *found;
}

std::string JsonFields::text(const std::string& name) const {
  const json& value = at(name);
  if (!value.is_string()) refuse(name, "a text", value);
  return value.get<std::string>();
}

int JsonFields::natural(const std::string& name) const {
  return natural(name, at(name));
}

int JsonFields::inner_natural(const std::string& name) const {
  return natural(name, inner(name));
}

double JsonFields::inner_number(const std::string& name) const {
  const json value = inner(name);
  if (!value.is_number()) refuse(name, "a number", value);
  return value.get<double>();
}

int JsonFields::natural(const std::string& name, const json& value) const {
  if (!value.is_number_unsigned() || value > std::numeric_limits<int>::max()) {
    refuse(name, "a whole number below 2^31", value);
  }
  return value.get<int>();
}

json JsonFields::inner(const std::string& name) const {
  return parse_strict_json(text(name), file_, key_ + "." + name);
}

json JsonFields::inner_array(const std::string& name) const {
  json value = inner(name);
  if (!value.is_array()) refuse(name, "an array", value);
  return value;
}

}  // namespace graspdb
