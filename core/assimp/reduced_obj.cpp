// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include "graspdb/core/error.h"
#include "reduced_files.h"

namespace graspdb {
namespace {

constexpr std::size_t kMostNames = 10000;  // of objects, groups and materials
constexpr std::size_t kLongestName = 500;

enum Kind { kVertex, kNormal, kKindCount };  // what the corners of a face name

std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view kBlank = " \t\r\v\f";
  std::vector<std::string_view> words;
  for (std::size_t start = line.find_first_not_of(kBlank); start != line.npos;) {
    const std::size_t end = std::min(line.find_first_of(kBlank, start), line.size());
    words.push_back(line.substr(start, end - start));
    start = line.find_first_not_of(kBlank, end);
  }
  return words;
}

class ObjReducer {
 public:
  ObjReducer(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  std::string reduced() {
    while (!text_.empty()) take_line(next_line());
    for (const int kind : {kVertex, kNormal}) {
      if (largest_[kind] > counts_[kind]) {
        throw Error({file_, "f", fmt::format("indices up to {}", counts_[kind]),
                     fmt::format("{}", largest_[kind])});
      }
    }
    return std::move(result_);
  }

 private:
  [[noreturn]] void refuse(const std::string& expected, std::string_view found) const {
    throw Error({file_, fmt::format("line {}", line_), expected, std::string(found.substr(0, 80))});
  }

  // A backslash at a line's end joins it with the next one.
  std::string next_line() {
    std::string line;
    for (bool goes_on = true; goes_on;) {
      const std::size_t end = std::min(text_.find('\n'), text_.size());
      std::string_view part = text_.substr(0, end);
      text_.remove_prefix(std::min(end + 1, text_.size()));
      ++line_;
      if (part.ends_with('\r')) part.remove_suffix(1);
      goes_on = part.ends_with('\\') && !text_.empty();
      if (part.ends_with('\\')) part.remove_suffix(1);
      line.append(part) += ' ';
    }
    return line;
  }

  void take_line(const std::string& line) {
    const std::vector<std::string_view> words = words_of(line);
    if (words.empty()) return;
    if (words[0] == "v") return take_numbers(words, kVertex, {3, 4, 6});
    if (words[0] == "vn") return take_numbers(words, kNormal, {3});
    if (words[0] == "f") return take_face(words);
    if (words[0] == "o" || words[0] == "g" || words[0] == "usemtl") take_name(words);
  }

  void take_numbers(const std::vector<std::string_view>& words, Kind kind,
                    const std::vector<std::size_t>& sizes) {
    if (std::ranges::count(sizes, words.size() - 1) == 0) {
      refuse(fmt::format("{} and as many numbers as it has", words[0]),
             fmt::format("{}", words.size() - 1));
    }
    result_ += words[0];
    for (std::size_t i = 1; i < words.size(); ++i) take_number(words[i]);
    result_ += '\n';
    ++counts_[kind];
  }

  void take_number(std::string_view word) {
    const std::string_view digits = word.substr(word.starts_with('+') ? 1 : 0);
    double value = 0;
    const auto [end, fault] = std::from_chars(digits.begin(), digits.end(), value);
    if (fault != std::errc() || end != digits.end() || !(std::abs(value) <= kLargestCoordinate)) {
      refuse(fmt::format("a number up to {:g}", kLargestCoordinate), word);
    }
    result_ += ' ';
    result_ += digits;
  }

  void take_face(const std::vector<std::string_view>& words) {
    if (words.size() < 4) return;  // a point or a line
    result_ += 'f';
    for (std::size_t i = 1; i < words.size(); ++i) take_corner(words[i]);
    result_ += '\n';
  }

  // "7", "7/8", "7/8/9" or "7//9": a vertex, a texture coordinate, a normal.
  void take_corner(std::string_view corner) {
    const std::size_t first = std::min(corner.find('/'), corner.size());
    const std::size_t second = std::min(corner.find('/', first + 1), corner.size());
    result_ += ' ';
    take_index(corner.substr(0, first), kVertex);
    if (second == corner.size()) return;
    result_ += "//";
    take_index(corner.substr(second + 1), kNormal);
  }

  // Counted from 1, or with a minus from the end of what there is so far.
  void take_index(std::string_view word, int kind) {
    long index = 0;
    const auto [end, fault] = std::from_chars(word.begin(), word.end(), index);
    if (index < 0) index += counts_[kind] + 1;
    if (fault != std::errc() || end != word.end() || index < 1) refuse("an index", word);
    largest_[kind] = std::max(largest_[kind], index);
    result_ += std::to_string(index);
  }

  void take_name(const std::vector<std::string_view>& words) {
    if (++names_ > kMostNames) refuse(fmt::format("at most {} names", kMostNames), "more");
    std::string line = fmt::format("{}", fmt::join(words, " "));
    std::ranges::replace(line, '\\', '/');  // before a line's end it would join two lines
    const bool is_text = std::ranges::none_of(line, [](unsigned char c) { return c < ' '; });
    if (line.size() > kLongestName || !is_text) refuse("a name", "another text");
    result_ += line + '\n';
  }

  std::string_view text_;
  const std::string& file_;
  std::string result_;
  std::size_t line_ = 0, names_ = 0;
  std::array<long, kKindCount> counts_{}, largest_{};
};

}  // namespace

std::string reduced_obj(std::string_view text, const std::string& file) {
  return ObjReducer(text, file).reduced();
}

}  // namespace graspdb
