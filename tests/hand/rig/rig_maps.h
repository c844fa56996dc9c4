// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/hand/rig/rig.h"
#include "support/replaced.h"
#include "support/temporary_directory.h"

namespace graspdb::testing {

inline const std::filesystem::path kHands = GRASPDB_SOURCE_DIR "/assets/hands";
inline const std::filesystem::path kMale = kHands / "male.glb";

// The male hand's rig map with one piece of text in place of another.
inline std::string map_with(const std::string& old_text, const std::string& new_text) {
  return replaced(read_text(rig_map_beside(kMale)), old_text, new_text);
}

inline Hand load_with(const std::string& map, const std::filesystem::path& hand_file = kMale) {
  const TemporaryDirectory directory;
  write_text(directory / "map.toml", map);
  return load_hand(hand_file, directory / "map.toml");
}

// What loading says to a map.
inline std::string refusal_of(const std::string& map) {
  try {
    load_with(map);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

inline std::string refusal_with(const std::string& old_text, const std::string& new_text) {
  return refusal_of(map_with(old_text, new_text));
}

}  // namespace graspdb::testing
