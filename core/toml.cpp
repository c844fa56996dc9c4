// SPDX-License-Identifier: MIT
#include "graspdb/core/toml.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"

namespace graspdb {

struct TomlTable::Node {
  std::shared_ptr<const toml::table> root;  // keeps `table` alive
  const toml::table* table = nullptr;
  std::string file;
  std::string path;  // of this table inside the file, "" or "object."
  mutable std::set<std::string, std::less<>> known;
};

namespace {

std::string kind_of(const toml::node* node) {
  if (node == nullptr) return "nothing";
  std::ostringstream text;
  text << node->type();
  return text.str();
}

std::string show(const toml::node* node) {
  if (node == nullptr) return "nothing";
  if (const auto* text = node->as_string()) return fmt::format("\"{}\"", text->get());
  if (const auto* number = node->as_integer()) return fmt::format("{}", number->get());
  if (const auto* number = node->as_floating_point()) return fmt::format("{}", number->get());
  return "a " + kind_of(node);
}

}  // namespace

TomlTable::TomlTable(std::shared_ptr<Node> node) : node_(std::move(node)) {}

TomlTable TomlTable::load(const std::filesystem::path& path) {
  return parse(read_text(path), path.string());
}

TomlTable TomlTable::parse(std::string_view text, const std::string& name) {
  try {
    auto root = std::make_shared<const toml::table>(toml::parse(text, name));
    auto node = std::make_shared<Node>();
    node->table = root.get();
    node->root = std::move(root);
    node->file = name;
    return TomlTable(std::move(node));
  } catch (const toml::parse_error& fault) {
    throw Error(
        fmt::format("{}: line {}: {}", name, fault.source().begin.line, fault.description()));
  }
}

void TomlTable::fail(std::string_view key, const std::string& expected,
                     const std::string& found) const {
  throw Error({node_->file, node_->path + std::string(key), expected, found});
}

const std::string& TomlTable::file() const {
  return node_->file;
}

bool TomlTable::has(std::string_view key) const {
  node_->known.emplace(key);
  return node_->table->contains(key);
}

double TomlTable::number(std::string_view key, double low, double high) const {
  const toml::node* node = has(key) ? node_->table->get(key) : nullptr;
  const auto value = node != nullptr && node->is_number() ? node->value<double>() : std::nullopt;
  if (!value || !(*value >= low && *value <= high)) {
    fail(key, fmt::format("a number from {} to {}", low, high), show(node));
  }
  return *value;
}

double TomlTable::number_or(std::string_view key, double otherwise, double low, double high) const {
  return has(key) ? number(key, low, high) : otherwise;
}

int TomlTable::integer(std::string_view key, int low, int high) const {
  const toml::node* node = has(key) ? node_->table->get(key) : nullptr;
  const auto* value = node != nullptr ? node->as_integer() : nullptr;
  if (value == nullptr || value->get() < low || value->get() > high) {
    fail(key, fmt::format("a whole number from {} to {}", low, high), show(node));
  }
  return static_cast<int>(value->get());
}

int TomlTable::integer_or(std::string_view key, int otherwise, int low, int high) const {
  return has(key) ? integer(key, low, high) : otherwise;
}

bool TomlTable::boolean_or(std::string_view key, bool otherwise) const {
  if (!has(key)) return otherwise;
  const toml::node* node = node_->table->get(key);
  if (!node->is_boolean()) fail(key, "true or false", show(node));
  return *node->value<bool>();
}

std::string TomlTable::string(std::string_view key) const {
  const toml::node* node = has(key) ? node_->table->get(key) : nullptr;
  if (node == nullptr || !node->is_string()) fail(key, "a text", show(node));
  return *node->value<std::string>();
}

std::string TomlTable::string_or(std::string_view key, const std::string& otherwise) const {
  return has(key) ? string(key) : otherwise;
}

std::string TomlTable::choice(std::string_view key,
                              const std::vector<std::string_view>& names) const {
  std::string name = string(key);
  if (std::ranges::find(names, name) == names.end()) {
    fail(key, fmt::format("one of {}", fmt::join(names, ", ")), toml_string(name));
  }
  return name;
}

std::vector<double> TomlTable::numbers(std::string_view key, int size, double low,
                                       double high) const {
  const toml::node* node = has(key) ? node_->table->get(key) : nullptr;
  const toml::array* array = node != nullptr ? node->as_array() : nullptr;
  const std::string expected =
      fmt::format("{} numbers from {} to {}", size < 0 ? "some" : std::to_string(size), low, high);
  if (array == nullptr) fail(key, expected, show(node));
  if (size >= 0 && array->size() != static_cast<std::size_t>(size)) {
    fail(key, expected, fmt::format("{}", array->size()));
  }
  std::vector<double> values;
  for (const toml::node& element : *array) {
    const auto value = element.is_number() ? element.value<double>() : std::nullopt;
    if (!value || !(*value >= low && *value <= high)) fail(key, expected, show(&element));
    values.push_back(*value);
  }
  return values;
}

std::vector<int> TomlTable::integers(std::string_view key, int low, int high) const {
  std::vector<int> list;
  for (const double value : numbers(key, -1, low, high)) {
    if (value != std::floor(value)) fail(key, "whole numbers", fmt::format("{}", value));
    list.push_back(static_cast<int>(value));
  }
  return list;
}

std::filesystem::path TomlTable::found(std::string_view key, const std::string& path,
                                       const std::filesystem::path& beside) const {
  for (const std::filesystem::path& candidate : {beside / path, data_directory() / path}) {
    std::error_code fault;  // such as a name that no file can have
    if (std::filesystem::exists(candidate, fault)) return candidate;
    if (fault) fail(key, "a path", fault.message());
  }
  return data_directory() / path;
}

Eigen::Vector3d TomlTable::vector3(std::string_view key, double low, double high) const {
  const std::vector<double> v = numbers(key, 3, low, high);
  return {v[0], v[1], v[2]};
}

std::vector<std::string> TomlTable::strings(std::string_view key) const {
  const toml::node* node = has(key) ? node_->table->get(key) : nullptr;
  const toml::array* array = node != nullptr ? node->as_array() : nullptr;
  if (array == nullptr) fail(key, "a list of texts", show(node));
  std::vector<std::string> values;
  for (const toml::node& element : *array) {
    if (!element.is_string()) fail(key, "a list of texts", show(&element));
    values.push_back(*element.value<std::string>());
  }
  return values;
}

TomlTable TomlTable::table(std::string_view key) const {
  auto found = table_if_any(key);
  if (!found) fail(key, "a table", "nothing");
  return *found;
}

std::optional<TomlTable> TomlTable::table_if_any(std::string_view key) const {
  if (!has(key)) return std::nullopt;
  const toml::node* node = node_->table->get(key);
  if (!node->is_table()) fail(key, "a table", show(node));
  auto child = std::make_shared<Node>();
  child->root = node_->root;
  child->table = node->as_table();
  child->file = node_->file;
  child->path = fmt::format("{}{}.", node_->path, key);
  return TomlTable(std::move(child));
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
  if (!has(key)) return {};
  const toml::array* array = node_->table->get(key)->as_array();
  if (array == nullptr) fail(key, "a list of tables", show(node_->table->get(key)));
  std::vector<TomlTable> children;
  for (const toml::node& element : *array) {
    if (!element.is_table()) fail(key, "a list of tables", show(&element));
    auto child = std::make_shared<Node>();
    child->root = node_->root;
    child->table = element.as_table();
    child->file = node_->file;
    child->path = fmt::format("{}{}[{}].", node_->path, key, children.size());
    children.push_back(TomlTable(std::move(child)));
  }
  return children;
}

std::vector<std::string> TomlTable::keys() const {
  std::vector<std::string> names;
  for (const auto& [key, node] : *node_->table) names.emplace_back(key.str());
  return names;
}

void TomlTable::finish() const {
  for (const auto& [key, node] : *node_->table) {
    if (node_->known.contains(key.str())) continue;
    fail(key.str(), fmt::format("one of {}", fmt::join(node_->known, ", ")), "an unknown key");
  }
}

std::string toml_string(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      quoted += {'\\', c};
    } else if (byte < 0x20 || byte == 0x7f) {
      quoted += fmt::format("\\u{:04x}", byte);
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

}  // namespace graspdb
