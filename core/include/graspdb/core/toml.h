// SPDX-License-Identifier: MIT
// TOML files for people, read strictly: a key that nobody asked for is an error, and so is a value
// of another kind or outside its range. Units are part of the key (`diameter_mm`, `pip_deg`).
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace graspdb {

// One table of a TOML file. Every getter marks its key as known; finish() throws Error for the
// first key that was never asked for. All Errors name file and key, what was expected and what was
// found.
class TomlTable {
 public:
  static TomlTable load(const std::filesystem::path& path);
  // `name` stands for the file in messages.
  static TomlTable parse(std::string_view text, const std::string& name);

  bool has(std::string_view key) const;
  double number(std::string_view key, double low, double high) const;  // low <= value <= high
  double number_or(std::string_view key, double otherwise, double low, double high) const;
  int integer(std::string_view key, int low, int high) const;
  int integer_or(std::string_view key, int otherwise, int low, int high) const;
  bool boolean_or(std::string_view key, bool otherwise) const;
  std::string string(std::string_view key) const;
  std::string string_or(std::string_view key, const std::string& otherwise) const;
  std::string choice(std::string_view key, const std::vector<std::string_view>& names) const;
  // `size` numbers, or any count when size < 0.
  std::vector<double> numbers(std::string_view key, int size, double low, double high) const;
  std::vector<int> integers(std::string_view key, int low, int high) const;      // any count
  Eigen::Vector3d vector3(std::string_view key, double low, double high) const;  // each of them
  std::vector<std::string> strings(std::string_view key) const;
  // Where the path `path`, which stands under `key`, leads: it is absolute, or seen from the folder
  // `beside`, or from the data directory.
  std::filesystem::path found(std::string_view key, const std::string& path,
                              const std::filesystem::path& beside) const;
  TomlTable table(std::string_view key) const;
  std::optional<TomlTable> table_if_any(std::string_view key) const;
  std::vector<TomlTable> tables(std::string_view key) const;  // empty when the key is absent
  std::vector<std::string> keys() const;                      // in the file's own (sorted) order

  void finish() const;  // also every table that was handed out must be finished by its reader
  const std::string& file() const;
  [[noreturn]] void fail(std::string_view key, const std::string& expected,
                         const std::string& found) const;

 private:
  struct Node;
  explicit TomlTable(std::shared_ptr<Node> node);
  std::shared_ptr<Node> node_;
};

// The text as a TOML file states it: in quotes, with what they cannot hold escaped.
std::string toml_string(std::string_view text);

}  // namespace graspdb
