// SPDX-License-Identifier: MIT
#include "fbx_bones.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>

#include "graspdb/core/error.h"

namespace graspdb {
namespace {

// Visits all places where `part` begins.
template <typename Visit>
void for_each_place(std::string_view bytes, std::string_view part, const Visit& visit) {
  for (std::size_t at = bytes.find(part); at != bytes.npos; at = bytes.find(part, at + 1))
    visit(at);
}

// Whether the line up to here is `Model: 123, ` or, in old files, `Model: `.
bool begins_model(std::string_view bytes) {
  const std::string_view line = bytes.substr(bytes.find_last_of("\r\n") + 1);
  const std::size_t start = line.find_first_not_of(" \t");
  return start != line.npos && line.substr(start).starts_with("Model:");
}

// A text of a binary file is 'S', its length in four bytes, and itself.
std::string_view text_that_ends(std::string_view bytes, std::size_t length_with_class) {
  constexpr std::size_t kLongestName = 1024, kHead = 5;
  for (std::size_t size = 0; size <= kLongestName && size + kHead <= bytes.size(); ++size) {
    const std::size_t head = bytes.size() - size - kHead;
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data() + head + 1, sizeof(length));
    if (bytes[head] == 'S' && length == size + length_with_class) return bytes.substr(head + kHead);
  }
  return {};
}

class NodeNames {
 public:
  void add(std::string_view name, bool is_bone) {
    Uses& uses = uses_[std::string(name)];
    ++uses.count;
    uses.has_bone = uses.has_bone || is_bone;
  }
  void require_own(const std::string& file) const {
    for (const auto& [name, uses] : uses_) {
      if (!uses.has_bone || uses.count == 1) continue;
      throw Error(
          {file, name, "one node of this name, since it is a bone", std::to_string(uses.count)});
    }
  }

 private:
  struct Uses {
    unsigned count = 0;
    bool has_bone = false;
  };
  std::map<std::string, Uses> uses_;
};

}  // namespace

void require_own_bone_names(std::string_view bytes, const std::string& file) {
  constexpr std::string_view kText = "\"Model::", kTextBone = "\", \"LimbNode\"";
  constexpr std::string_view kBinary = {"\0\1Model", 7}, kBinaryBone = {"S\10\0\0\0LimbNode", 13};
  NodeNames names;
  for_each_place(bytes, kText, [&](std::size_t at) {
    const std::string_view rest = bytes.substr(at + kText.size());
    const std::size_t end = std::min(rest.find('"'), rest.size());
    if (!begins_model(bytes.substr(0, at))) return;
    names.add(rest.substr(0, end), rest.substr(end).starts_with(kTextBone));
  });
  for_each_place(bytes, kBinary, [&](std::size_t at) {
    const std::string_view name = text_that_ends(bytes.substr(0, at), kBinary.size());
    names.add(name, bytes.substr(at + kBinary.size()).starts_with(kBinaryBone));
  });
  names.require_own(file);
}

}  // namespace graspdb
