// SPDX-License-Identifier: MIT
#include "lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "graspdb/core/error.h"

namespace graspdb {
namespace {

using Status = HandCheckLine::Status;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

std::string_view status_name(Status status) {
  switch (status) {
    case Status::kPass:
      return "pass";
    case Status::kFail:
      return "fail";
    case Status::kNotApplicable:
      return "not applicable";
  }
  GRASPDB_CHECK(false);
}

bool passes(std::span<const HandCheckLine> lines) {
  return std::none_of(lines.begin(), lines.end(),
                      [](const HandCheckLine& line) { return line.status == Status::kFail; });
}

Gate at_most(double high) {
  return {-kInfinity, high, fmt::format("<= {:.6g}", high)};
}

Gate at_least(double low) {
  return {low, kInfinity, fmt::format(">= {:.6g}", low)};
}

Gate above(double low) {
  return {std::nextafter(low, kInfinity), kInfinity, fmt::format("> {:.6g}", low)};
}

Gate between(double low, double high) {
  return {low, high, fmt::format("{:.6g}..{:.6g}", low, high)};
}

Gate exactly(double value) {
  return {value, value, fmt::format("{:.6g}", value)};
}

HandCheckLine judged(const std::string& name, double value, const std::string& unit,
                     const Gate& gate, const std::string& why) {
  const bool good = value >= gate.low && value <= gate.high;
  return {name, value, unit, gate.text, good ? Status::kPass : Status::kFail, why};
}

HandCheckLine not_applicable(const std::string& name, const std::string& unit, const Gate& gate,
                             const std::string& why) {
  return {name, std::nan(""), unit, gate.text, Status::kNotApplicable, why};
}

bool moves_skin(const Hand& hand, int bone) {
  for (const SkinWeights& skin : hand.weights) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (skin.bone[i] == bone && skin.weight[i] > 0) return true;
    }
  }
  return false;
}

JointAngles Limit::angles() const {
  JointAngles angles = JointAngles::Zero();
  angles[angle] = value;
  return angles;
}

std::string Limit::text() const {
  return fmt::format("{} {:.0f} deg", angle_info(angle).name, degrees(value));
}

std::vector<Limit> limits_of(const AngleGroup& group) {
  std::vector<Limit> limits;
  for (int angle = group.first; angle < group.end; ++angle) {
    limits.push_back({angle, angle_info(angle).lower});
    limits.push_back({angle, angle_info(angle).upper});
  }
  return limits;
}

std::string no_skin_on(int bone) {
  return fmt::format("{} moves no skin", bone_name(bone));
}

bool Missing::lacks_skin(const Hand& hand, int bone) {
  if (moves_skin(hand, bone)) return false;
  if (what_.empty()) what_ = no_skin_on(bone);
  return true;
}

HandCheckLine judged_unless(const Missing& missing, const std::string& name, const Worst& worst,
                            const std::string& unit, const Gate& gate) {
  HandCheckLine line = judged(name, worst.value, unit, gate, worst.where);
  if (missing.what().empty() || line.status == Status::kFail) return line;
  return not_applicable(name, unit, gate, missing.what());
}

}  // namespace graspdb
