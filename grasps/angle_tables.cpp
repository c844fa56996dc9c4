// SPDX-License-Identifier: MIT
#include "angle_tables.h"

#include <fmt/format.h>

#include <array>
#include <vector>

#include "graspdb/core/transform.h"

namespace graspdb {
namespace {

struct AngleKey {
  std::string_view key;
  int angle;
};

struct AngleTable {
  std::string_view key;
  std::vector<AngleKey> angles;
};

AngleTable finger_table(std::string_view key, int finger) {
  return {key,
          {{"cmc", finger_angle(finger, kCmcFlexion)},
           {"mcp", finger_angle(finger, kMcpFlexion)},
           {"abduction", finger_angle(finger, kMcpAbduction)},
           {"pip", finger_angle(finger, kPipFlexion)},
           {"dip", finger_angle(finger, kDipFlexion)}}};
}

const std::array<AngleTable, 6>& angle_tables() {
  static const std::array<AngleTable, 6> tables = {{
      {"wrist_deg", {{"flexion", kWristFlexion}, {"deviation", kWristDeviation}}},
      {"thumb_deg",
       {{"cmc_flexion", kThumbCmcFlexion},
        {"cmc_abduction", kThumbCmcAbduction},
        {"cmc_axial", kThumbCmcAxial},
        {"mcp", kThumbMcpFlexion},
        {"mcp_abduction", kThumbMcpAbduction},
        {"ip", kThumbIpFlexion}}},
      finger_table("index_deg", 0),
      finger_table("middle_deg", 1),
      finger_table("ring_deg", 2),
      finger_table("little_deg", 3),
  }};
  return tables;
}

}  // namespace

JointAngles read_angles(const TomlTable& table, double otherwise) {
  JointAngles angles = JointAngles::Constant(otherwise);
  for (const AngleTable& digit : angle_tables()) {
    const auto found = table.table_if_any(digit.key);
    if (!found) continue;
    for (const auto& [key, angle] : digit.angles) {
      if (!found->has(key)) continue;
      const AngleInfo& info = angle_info(angle);
      angles[angle] = radians(found->number(key, info.lower_deg(), info.upper_deg()));
    }
    found->finish();
  }
  return angles;
}

std::string write_angles(const JointAngles& angles) {
  std::string text;
  for (const AngleTable& digit : angle_tables()) {
    std::string entries;
    for (const auto& [key, angle] : digit.angles) {
      entries += fmt::format("{}{} = {:.6f}", entries.empty() ? "" : ", ", key,
                             degrees(angles[angle]) + 0.0);
    }
    text += fmt::format("{} = {{ {} }}\n", digit.key, entries);
  }
  return text;
}

}  // namespace graspdb
