// SPDX-License-Identifier: MIT
// What the text of an option may be. Each check says it in --help, in words. CLI11's own ones let
// NaN into every range, take -1 for a large whole number and 010 for 8, and name internal numbers.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

namespace graspdb::cli {

CLI::Validator range(double low, double high);
CLI::Validator range(int low, int high);  // whole numbers; the largest int is no limit
CLI::Validator natural();                 // whole numbers from 0 to 2^64 - 1

CLI::Validator one_of(const std::vector<std::string>& names);

// Turns a name into its value, for ->transform().
CLI::Validator named_number(const std::map<std::string, int>& values);
template <typename Enum>
CLI::Validator named(const std::map<std::string, Enum>& values) {
  std::map<std::string, int> numbers;
  for (const auto& [name, value] : values) numbers[name] = static_cast<int>(value);
  return named_number(numbers);
}

// A place that cannot be written is told before the work, not after it. Without extensions any
// will do.
CLI::Validator output_file(const std::vector<std::string>& extensions = {});
CLI::Validator output_file_or_dash();  // -: standard output
CLI::Validator output_folder();

// No text option of any verb takes an empty text: scripts make one of a variable that is not set,
// and it would count as not given.
void refuse_empty_texts(CLI::App& app);

}  // namespace graspdb::cli
