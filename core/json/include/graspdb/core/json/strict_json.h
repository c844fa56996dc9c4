// SPDX-License-Identifier: MIT
// JSON that may be hostile, read strictly. Every Error names the file and the entry, as `key.name`,
// what was expected and what was found. Thread-safe.
#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "graspdb/core/camera.h"

namespace graspdb {

// A key that stands twice in one object and nesting deeper than 16 are faults. Numbers are finite:
// JSON knows no others, and one beyond a double's range is a fault. Throws Error with this file and
// key; the key may be empty.
nlohmann::json parse_strict_json(std::string_view text, const std::string& file,
                                 const std::string& key);

// The entries of one JSON object, each asked for by name and kind; one that is absent is a fault.
// Keeps a reference to the object.
class JsonFields {
 public:
  JsonFields(const nlohmann::json& object, std::string file, std::string key);

  bool has(const std::string& name) const;
  auto items() const { return object_.items(); }  // of all, known or not
  const nlohmann::json& at(const std::string& name) const;
  JsonFields fields(const std::string& name) const;
  std::string text(const std::string& name) const;
  int integer(const std::string& name, int low, int high) const;
  int natural(const std::string& name) const;  // 0 <= value < 2^31
  double number(const std::string& name) const;
  double positive(const std::string& name) const;
  // Exactly so many numbers.
  std::vector<double> numbers(const std::string& name, std::size_t count) const;
  // A matrix of fixed size, row by row.
  template <typename Matrix>
  Matrix matrix(const std::string& name) const;
  // Exactly so many points of three numbers.
  std::vector<Eigen::Vector3d> points(const std::string& name, std::size_t count) const;

  // A value that is JSON inside a text: safetensors allows nothing but texts in __metadata__.
  nlohmann::json inner(const std::string& name) const;
  int inner_natural(const std::string& name) const;
  double inner_number(const std::string& name) const;
  nlohmann::json inner_array(const std::string& name) const;

 private:
  std::string key_of(const std::string& name) const;
  [[noreturn]] void refuse(const std::string& name, const std::string& expected,
                           const nlohmann::json& found) const;
  int integer(const std::string& name, const nlohmann::json& value, int low, int high) const;
  double number(const std::string& name, const nlohmann::json& value) const;
  std::vector<double> numbers(const std::string& name, const nlohmann::json& list,
                              std::size_t count) const;

  const nlohmann::json& object_;
  std::string file_;
  std::string key_;
};

template <typename Matrix>
Matrix JsonFields::matrix(const std::string& name) const {
  Matrix matrix;
  const std::vector<double> list = numbers(name, static_cast<std::size_t>(matrix.size()));
  auto next = list.begin();
  for (int row = 0; row < matrix.rows(); ++row) {
    for (int column = 0; column < matrix.cols(); ++column) matrix(row, column) = *next++;
  }
  return matrix;
}

// As camera_json (json_numbers.h) writes it: 1 to 100,000 pixels a side, focal lengths above 0.
Intrinsics read_camera(const JsonFields& fields);

}  // namespace graspdb
