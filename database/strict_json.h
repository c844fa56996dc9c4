// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace graspdb {

// Parses JSON that may be hostile: a key that stands twice in one object and nesting deeper than 16
// are faults. Throws Error with this file and key.
nlohmann::json parse_strict_json(std::string_view text, const std::string& file,
                                 const std::string& key);

// The entries of one JSON object, each asked for by name and kind. Throws Error that names the
// entry as `key.name`. Keeps a reference to the object.
class JsonFields {
 public:
  JsonFields(const nlohmann::json& object, std::string file, std::string key);

  bool has(const std::string& name) const;
  const nlohmann::json& at(const std::string& name) const;
  std::string text(const std::string& name) const;
  int natural(const std::string& name) const;  // 0 <= value < 2^31
  // A value that is JSON inside a text: safetensors allows nothing but texts in __metadata__.
  nlohmann::json inner(const std::string& name) const;
  int inner_natural(const std::string& name) const;
  double inner_number(const std::string& name) const;
  nlohmann::json inner_array(const std::string& name) const;

 private:
  int natural(const std::string& name, const nlohmann::json& value) const;
  [[noreturn]] void refuse(const std::string& name, const std::string& expected,
                           const nlohmann::json& found) const;

  const nlohmann::json& object_;
  std::string file_;
  std::string key_;
};

}  // namespace graspdb
