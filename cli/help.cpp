// SPDX-License-Identifier: MIT
#include "help.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace graspdb::cli {
namespace {

// CLI11 joins what it knows: the type, and after a colon what each check says.
struct Kind {
  std::string type, words;
};

Kind kind_of(const CLI::Option& option) {
  const std::string name = option.get_type_name();
  const std::size_t colon = name.find(':');
  if (colon == name.npos) return {name, ""};
  return {name.substr(0, colon), name.substr(colon + 1)};
}

bool is_place(const std::string& words) {
  return words == "FILE" || words == "FOLDER";
}

std::string placeholder(const Kind& kind) {
  if (is_place(kind.words)) return kind.words;
  if (kind.type == "INT" || kind.type == "UINT") return "N";
  if (kind.type == "FLOAT") return "X";
  return kind.type == "ENUM" ? "NAME" : kind.type;
}

std::string names_of(const std::set<CLI::Option*>& options) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options) names.push_back(option->get_name());
  return fmt::format("{}", fmt::join(names, ", "));
}

// The description may tell of all of "both, free, held" already.
bool is_told(const std::string& words, const std::string& description) {
  const std::vector<std::string> names = CLI::detail::split(words, ',');
  return std::ranges::all_of(names, [&](const std::string& name) {
    return description.find(CLI::detail::trim_copy(name)) != description.npos;
  });
}

std::string conditions(const CLI::Option& option) {
  std::vector<std::string> all;
  const std::string words = kind_of(option).words;
  if (!is_place(words) && !is_told(words, option.get_description())) all.push_back(words);
  if (option.get_required() && !option.get_positional()) all.push_back("required");
  if (!option.get_needs().empty()) all.push_back("with " + names_of(option.get_needs()));
  if (!option.get_excludes().empty()) all.push_back("not with " + names_of(option.get_excludes()));
  return all.empty() ? "" : fmt::format(" ({})", fmt::join(all, "; "));
}

// In brackets, as those descriptions have it that say themselves what happens without the option.
std::string default_of(const CLI::Option& option) {
  const std::string& text = option.get_default_str();
  if (text.empty() || text == "[]" || text == "{}") return "";
  return text.starts_with('[') ? " " + text : fmt::format(" [{}]", text);
}

}  // namespace

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  if (option->get_positional() || option->get_type_size() == 0) return "";
  const std::string one = placeholder(kind_of(*option));
  std::string all = " " + one;
  const int least = option->get_expected_min();
  for (int i = 1; i < least; ++i) all += "," + one;
  if (option->get_expected_max() == CLI::detail::expected_max_vector_size) all += ",...";
  return all;
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
  const std::string& text = option->get_description();
  const std::size_t bracket = text.ends_with(']') ? text.rfind(" [") : text.npos;
  if (bracket == text.npos) return text + conditions(*option) + default_of(*option);
  return text.substr(0, bracket) + conditions(*option) + text.substr(bracket);
}

}  // namespace graspdb::cli
