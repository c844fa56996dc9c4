// SPDX-License-Identifier: MIT
#include "checks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <limits>
#include <optional>

#include "graspdb/core/file_name.h"

namespace graspdb::cli {
namespace {

namespace fs = std::filesystem;

// The whole text as a number, without spaces.
template <typename Number>
std::optional<Number> number_of(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  Number number{};
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

// CLI11 would read 010 as 8.
bool is_octal(const std::string& text) {
  const std::size_t digits = text.find_first_not_of("+-");
  return digits != text.npos && digits + 1 < text.size() && text[digits] == '0';
}

std::string unlike(const std::string& text, const std::string& expected) {
  return fmt::format("{}: expected {}", text, expected);
}

template <typename Number>
CLI::Validator in_range(const std::string& kind, Number low, Number high,
                        const std::string& words) {
  const auto check = [=](std::string& text) -> std::string {
    const std::optional<Number> number = number_of<Number>(text);
    const bool is_whole = std::numeric_limits<Number>::is_integer;
    if (number && *number >= low && *number <= high && !(is_whole && is_octal(text))) return "";
    return unlike(text, fmt::format("{}, {}", kind, words));
  };
  return CLI::Validator(check, words);
}

// The first folder above a place that is there.
fs::path folder_above(const fs::path& place) {
  fs::path folder = fs::absolute(place).parent_path();
  std::error_code unknown;
  while (folder.has_relative_path() && !fs::exists(folder, unknown)) folder = folder.parent_path();
  return folder;
}

// Why nothing can be made there; empty when it can.
std::string why_not_in(const fs::path& folder) {
  std::error_code unknown;
  if (!fs::is_directory(folder, unknown)) return fmt::format("{} is no folder", folder.string());
  if (::access(folder.c_str(), W_OK | X_OK) == 0) return "";
  return fmt::format("{}: {}", folder.string(), std::strerror(errno));
}

bool has_extension(const fs::path& file, const std::vector<std::string>& extensions) {
  return extensions.empty() || std::ranges::count(extensions, lower_extension(file)) > 0;
}

}  // namespace

CLI::Validator range(double low, double high) {
  return in_range("a number", low, high, fmt::format("{:g} to {:g}", low, high));
}

CLI::Validator range(int low, int high) {
  const bool has_limit = high < std::numeric_limits<int>::max();
  return in_range("a whole number", low, high,
                  has_limit ? fmt::format("{} to {}", low, high) : fmt::format("{} or more", low));
}

CLI::Validator natural() {
  return in_range<std::uint64_t>("a whole number", 0, std::numeric_limits<std::uint64_t>::max(),
                                 "0 or more");
}

CLI::Validator one_of(const std::vector<std::string>& names) {
  const std::string all = fmt::format("{}", fmt::join(names, ", "));
  const auto check = [=](std::string& text) {
    return std::ranges::count(names, text) > 0 ? "" : unlike(text, "one of " + all);
  };
  return CLI::Validator(check, all);
}

CLI::Validator named_number(const std::map<std::string, int>& values) {
  std::vector<std::string> names;
  for (const auto& [name, value] : values) names.push_back(name);
  const std::string all = fmt::format("{}", fmt::join(names, ", "));
  const auto turn = [=](std::string& text) -> std::string {
    const auto known = values.find(text);
    if (known == values.end()) return unlike(text, "one of " + all);
    text = std::to_string(known->second);
    return "";
  };
  return CLI::Validator(turn, all);
}

CLI::Validator output_file(const std::vector<std::string>& extensions) {
  const auto check = [=](std::string& text) -> std::string {
    std::error_code unknown;
    const fs::file_status status = fs::status(text, unknown);
    if (fs::exists(status) && !fs::is_regular_file(status)) return unlike(text, "a file to write");
    if (!has_extension(text, extensions))
      return unlike(text, fmt::format("a name that ends with {}", fmt::join(extensions, " or ")));
    const std::string why = why_not_in(folder_above(text));
    return why.empty() ? "" : fmt::format("{} cannot be written: {}", text, why);
  };
  return CLI::Validator(check, "FILE");
}

CLI::Validator output_file_or_dash() {
  const CLI::Validator file = output_file();
  return CLI::Validator([=](std::string& text) { return text == "-" ? "" : file(text); }, "FILE");
}

void refuse_empty_texts(CLI::App& app) {
  const CLI::Validator check([](std::string& text) { return text.empty() ? "empty" : ""; }, "");
  for (CLI::Option* option : app.get_options()) {
    if (option->get_type_name().starts_with("TEXT")) option->transform(check);  // comes first
  }
  for (CLI::App* verb : app.get_subcommands({})) refuse_empty_texts(*verb);
}

CLI::Validator output_folder() {
  const auto check = [](std::string& text) -> std::string {
    std::error_code unknown;
    const bool is_there = fs::exists(text, unknown);
    const std::string why = why_not_in(is_there ? fs::path(text) : folder_above(text));
    return why.empty() ? "" : fmt::format("{} cannot be written: {}", text, why);
  };
  return CLI::Validator(check, "FOLDER");
}

}  // namespace graspdb::cli
