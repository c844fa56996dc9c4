// SPDX-License-Identifier: MIT
#include "grasp_template.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/toml.h"

namespace graspdb::cli {
namespace {

namespace fs = std::filesystem;

constexpr int kFirstOwnNumber = 100, kLastNumber = 65535;

constexpr const char* kHead =
    R"(# One sentence on what the hand does. docs/grasps.md says what every key means.
# Then: graspdb grasp close, graspdb grasp check, and graspdb grasp sheet --out look.png, of this file.
)";

// A tripod on a ball, which closes and passes the check as it is.
constexpr const char* kBody = R"(
[taxonomy]
type = "precision"                              # power, intermediate, precision
opposition = "pad"                              # palm, pad, side
virtual_fingers = ["thumb", "index+middle"]     # those that act as one with + between them
thumb = "abducted"                              # or adducted

# What must meet the object, and with what part of it. A finger has pulp, tip, distal, middle and
# proximal, the thumb pulp, tip, distal, proximal and thenar, each also with _radial or _ulnar after it
# for that side of it; the palm has pads, hollow and heel.
[touch]
thumb = ["pulp"]
index = ["pulp"]
middle = ["pulp"]
free = ["palm", "ring", "little"]               # what must not touch

[object]
name = "ball"
shape = "sphere"
diameter_mm = 50
# shape = "cylinder"                            # along its z axis; a disk is a short one
# diameter_mm = 60
# length_mm = 90
# shape = "box"
# size_mm = [85, 54, 1]
# shape = "ring"                                # round its z axis
# inner_diameter_mm = 26
# thickness_mm = 6
# shape = "mesh"                                # a closed surface
# mesh = "mug.obj"                              # seen from this file
# unit = "mm"                                   # or cm, m
# scales_with_hand = true                       # sizes of a 193 mm hand; else the same on every hand
#
# Where its middle is in the closed hand, about: x to the little finger's side, y to the finger tips,
# z out of the back of the hand. Seen from the middle between the thumb's contact areas and those of
# the others, as they are in [start], or with position_mm from the wrist.
from_contacts_mm = [0, 0, 0]
# position_mm = [2, 82, -50]
# z_axis = [0, 0, 1]                            # where the object's own axes point in the hand
# x_axis = [1, 0, 0]
approach_mm = [0, 0, -25]                       # how much further off it is when the hand is at rest

# Where the closing begins; what is left out is 0. Better too open than inside the object.
[start]
wrist_deg = { flexion = -10, deviation = 0 }
thumb_deg = { cmc_flexion = 30, cmc_abduction = 50, cmc_axial = 35, mcp = 10, ip = 20 }
index_deg = { mcp = 40, abduction = 4, pip = 50, dip = 20 }
middle_deg = { mcp = 45, abduction = -2, pip = 50, dip = 25 }
ring_deg = { mcp = 75, pip = 80, dip = 45 }
little_deg = { mcp = 80, pip = 75, dip = 45 }

# Only where the straight way from rest to closed leads through the object: what to pass on the way.
# [[waypoint]]
# at_percent = 60
# index_deg = { mcp = 10 }                      # what is not stated goes straight
# approach_mm = [0, 0, -20]
)";

std::string file_stem(const std::string& name) {
  const auto is_word = [](unsigned char c) { return std::isalnum(c) != 0; };
  std::string stem;
  for (const char c : name) {
    if (!is_word(static_cast<unsigned char>(c)) && c != ' ' && c != '-' && c != '_') {
      throw Error({.key = "NAME",
                   .expected = "letters, digits, spaces, - and _",
                   .found = "\"" + name + "\""});
    }
    stem += is_word(static_cast<unsigned char>(c)) ? static_cast<char>(std::tolower(c)) : '_';
  }
  if (stem.find_first_not_of('_') == std::string::npos) {
    throw Error({.key = "NAME", .expected = "a name", .found = "\"" + name + "\""});
  }
  return stem;
}

std::set<int> numbers_in(const fs::path& directory) {
  std::set<int> numbers;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory)) {
    if (entry.path().extension() != ".toml" || entry.path().filename() == "rest.toml") continue;
    const TomlTable file = TomlTable::load(entry.path());
    if (file.has("number")) numbers.insert(file.integer("number", 1, kLastNumber));
  }
  return numbers;
}

}  // namespace

fs::path write_new_grasp(const std::string& name, const fs::path& directory) {
  const std::string stem = file_stem(name);
  fs::create_directories(directory);
  const std::set<int> taken = numbers_in(directory);
  int number = kFirstOwnNumber;
  while (taken.count(number) != 0) ++number;
  fs::path file = directory / fmt::format("{}_{}.toml", number, stem);
  if (fs::exists(file)) {
    throw Error({.file = file.string(), .expected = "a new file", .found = "one of that name"});
  }
  write_text(file, fmt::format("{}number = {}\nname = \"{}\"\n{}", kHead, number, name, kBody));
  return file;
}

}  // namespace graspdb::cli
