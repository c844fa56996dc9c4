// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <optional>
#include <set>

#include "angle_tables.h"
#include "contact_areas.h"
#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/toml.h"
#include "graspdb/geometry/mesh_solid.h"
#include "graspdb/grasps/grasp.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;

constexpr double kLargestMm = 1000;
constexpr double kSmallestMm = 0.1;

Eigen::Vector3d vector_or(const TomlTable& table, std::string_view key,
                          const Eigen::Vector3d& otherwise, double limit) {
  return table.has(key) ? table.vector3(key, -limit, limit) : otherwise;
}

int digit_named(const TomlTable& table, std::string_view key, const std::string& name) {
  const auto digit = digit_from_name(name);
  if (!digit) table.fail(key, "palm, thumb, index, middle, ring or little", name);
  return *digit;
}

// ["palm", "index+middle"] -> {{0}, {2, 3}}
std::vector<std::vector<int>> read_virtual_fingers(const TomlTable& table) {
  std::vector<std::vector<int>> fingers;
  for (const std::string& text : table.strings("virtual_fingers")) {
    std::vector<int>& finger = fingers.emplace_back();
    for (std::size_t start = 0; start <= text.size();) {
      const std::size_t end = std::min(text.find('+', start), text.size());
      finger.push_back(digit_named(table, "virtual_fingers", text.substr(start, end - start)));
      start = end + 1;
    }
  }
  return fingers;
}

void read_taxonomy(const TomlTable& table, Grasp& grasp) {
  grasp.type = table.choice("type", {"power", "intermediate", "precision"});
  const std::string opposition = table.choice("opposition", {"palm", "pad", "side"});
  grasp.opposition = opposition == "palm"  ? Opposition::kPalm
                     : opposition == "pad" ? Opposition::kPad
                                           : Opposition::kSide;
  grasp.virtual_fingers = read_virtual_fingers(table);
  grasp.thumb_abducted = table.choice("thumb", {"abducted", "adducted"}) == "abducted";
  table.finish();
}

void read_touch(const TomlTable& table, Grasp& grasp) {
  for (int digit = 0; digit < kPalmAndDigitCount; ++digit) {
    const std::string key(palm_or_digit_name(digit));
    if (!table.has(key)) continue;
    grasp.required_digits.push_back(digit);
    for (const std::string& name : table.strings(key)) {
      const auto area = contact_area(digit, name);
      if (!area) table.fail(key, "some of " + contact_area_names(digit), name);
      grasp.contacts.push_back(*area);
    }
  }
  if (table.has("free")) {
    for (const std::string& name : table.strings("free")) {
      grasp.free_digits.push_back(digit_named(table, "free", name));
    }
  }
  for (const int digit : grasp.free_digits) {
    if (std::count(grasp.required_digits.begin(), grasp.required_digits.end(), digit) != 0) {
      table.fail("free", "digits that touch nothing",
                 std::string(palm_or_digit_name(digit)) + ", which touches");
    }
  }
  table.finish();
}

// The digits that the taxonomy lets act must be among those that are brought to the object.
void require_virtual_fingers_touch(const TomlTable& file, const Grasp& grasp) {
  for (const std::vector<int>& finger : grasp.virtual_fingers) {
    for (const int digit : finger) {
      if (std::count(grasp.required_digits.begin(), grasp.required_digits.end(), digit) == 0) {
        const std::string name(palm_or_digit_name(digit));
        file.fail("touch", name + ", which taxonomy.virtual_fingers names", "no " + name);
      }
    }
  }
}

// In metres. Some files state their own.
std::optional<double> read_unit(const TomlTable& table) {
  if (!table.has("unit") && can_state_unit(table.string("mesh"))) return std::nullopt;
  const std::string unit = table.choice("unit", {"mm", "cm", "m"});
  return unit == "mm" ? 1e-3 : unit == "cm" ? 1e-2 : 1;
}

// A path in a grasp file is seen from that file.
std::shared_ptr<const Solid> read_mesh(const TomlTable& table, Grasp& grasp) {
  const std::optional<double> unit = read_unit(table);
  grasp.object_file = grasp.file.parent_path() / table.string("mesh");
  std::error_code unknown;  // such as a name that no file can have
  if (!fs::is_regular_file(grasp.object_file, unknown)) {
    table.fail("mesh", "a mesh file", "none at " + grasp.object_file.lexically_normal().string());
  }
  grasp.object_origin = table.string_or("origin", "");
  grasp.object_license = table.string_or("licence", "");
  return load_mesh_solid(grasp.object_file, unit);
}

std::shared_ptr<const Solid> read_solid(const TomlTable& table, Grasp& grasp) {
  const std::string shape = table.choice("shape", {"sphere", "cylinder", "box", "ring", "mesh"});
  const auto meters = [&](std::string_view key) {
    return table.number(key, kSmallestMm, kLargestMm) / 1000;
  };
  if (shape == "mesh") return read_mesh(table, grasp);
  if (shape == "ring") return make_ring(meters("inner_diameter_mm"), meters("thickness_mm"));
  if (shape == "sphere") return make_sphere(meters("diameter_mm"));
  if (shape == "cylinder") return make_cylinder(meters("diameter_mm"), meters("length_mm"));
  return make_box(table.vector3("size_mm", kSmallestMm, kLargestMm) / 1000);
}

Eigen::Matrix3d read_rotation(const TomlTable& table) {
  const Eigen::Vector3d z = vector_or(table, "z_axis", Eigen::Vector3d::UnitZ(), kLargestMm);
  const Eigen::Vector3d any =
      std::abs(z.normalized().x()) < 0.9 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
  const Eigen::Vector3d x = vector_or(table, "x_axis", any, kLargestMm);
  if (z.norm() < 1e-6) table.fail("z_axis", "a direction", "a zero vector");
  if (z.normalized().cross(x).norm() < 1e-6) {
    table.fail("x_axis", "a direction that differs from z_axis", "none");
  }
  return rotation_from_axes(2, z, x);
}

void read_object(const TomlTable& table, Grasp& grasp) {
  grasp.object_name = table.string("name");
  grasp.object = read_solid(table, grasp);
  grasp.object_scales = table.boolean_or("scales_with_hand", false);
  grasp.start.hand_from_object.rotation = read_rotation(table);
  grasp.from_contacts = table.has("from_contacts_mm") && !table.has("position_mm");
  grasp.start.hand_from_object.translation =
      table.vector3(grasp.from_contacts ? "from_contacts_mm" : "position_mm", -kLargestMm,
                    kLargestMm) /
      1000;
  grasp.approach = vector_or(table, "approach_mm", Eigen::Vector3d::Zero(), kLargestMm) / 1000;
  table.finish();
}

constexpr double kWrittenSlack = 1e-9;

void require_faded_ranges(const TomlTable& table, const JointAngles& angles) {
  const JointAngles clamped = clamp_to_range(angles);
  for (int i = 0; i < kAngleCount; ++i) {
    if (std::abs(angles[i] - clamped[i]) <= kWrittenSlack) continue;
    table.fail(angle_info(i).name,
               "at most " + std::to_string(degrees(clamped[i])) + " degrees at this flexion",
               std::to_string(degrees(angles[i])));
  }
}

JointAngles read_checked_angles(const TomlTable& table) {
  JointAngles angles = read_angles(table);
  require_faded_ranges(table, angles);
  return angles;
}

void read_waypoints(const TomlTable& file, Grasp& grasp) {
  double last = 0;
  for (const TomlTable& table : file.tables("waypoint")) {
    Waypoint& point = grasp.waypoints.emplace_back();
    point.progress = table.number("at_percent", 1, 99) / 100;
    if (point.progress <= last) {
      table.fail("at_percent", fmt::format("more than {:g}, as before it", 100 * last),
                 fmt::format("{:g}", 100 * point.progress));
    }
    last = point.progress;
    point.angles = read_angles(table, std::numeric_limits<double>::quiet_NaN());
    if (table.has("approach_mm")) {
      point.approach = vector_or(table, "approach_mm", grasp.approach, kLargestMm) / 1000;
    }
    table.finish();
  }
}

}  // namespace

Grasp load_grasp(const fs::path& path) {
  const TomlTable file = TomlTable::load(path);
  Grasp grasp;
  grasp.file = path;
  grasp.id = file.integer("number", 1, kLargestGrasp);
  grasp.name = file.string("name");
  read_taxonomy(file.table("taxonomy"), grasp);
  read_touch(file.table("touch"), grasp);
  require_virtual_fingers_touch(file, grasp);
  read_object(file.table("object"), grasp);
  const TomlTable start = file.table("start");
  grasp.start.angles = read_checked_angles(start);
  start.finish();
  read_waypoints(file, grasp);
  file.finish();
  return grasp;
}

fs::path grasp_directory() {
  return data_directory() / "grasps";
}

std::vector<Grasp> load_grasps(const fs::path& directory) {
  if (!fs::is_directory(directory)) {
    throw Error({.file = directory.string(), .expected = "a folder of grasps", .found = "none"});
  }
  std::set<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory)) {
    const fs::path& path = entry.path();
    if (path.extension() == ".toml" && path.filename() != "rest.toml") files.insert(path);
  }
  std::vector<Grasp> grasps;
  grasps.reserve(files.size());
  for (const fs::path& path : files) grasps.push_back(load_grasp(path));
  std::stable_sort(grasps.begin(), grasps.end(),
                   [](const Grasp& a, const Grasp& b) { return a.id < b.id; });
  for (std::size_t i = 1; i < grasps.size(); ++i) {
    if (grasps[i].id != grasps[i - 1].id) continue;
    throw Error({.file = grasps[i].file.string(),
                 .key = "number",
                 .expected = "a number of its own",
                 .found = std::to_string(grasps[i].id) + ", as in " + grasps[i - 1].file.string()});
  }
  return grasps;
}

JointAngles load_rest_pose(const fs::path& directory) {
  const fs::path own = directory / "rest.toml";
  const TomlTable file =
      TomlTable::load(fs::exists(own) ? own : data_directory() / "grasps" / "rest.toml");
  JointAngles angles = read_checked_angles(file);
  file.finish();
  return angles;
}

}  // namespace graspdb
