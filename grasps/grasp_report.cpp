// SPDX-License-Identifier: MIT
#include "graspdb/grasps/grasp_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "graspdb/core/append.h"

namespace graspdb {
namespace {

using Figure = double StepCheck::*;

double worst(const GraspCheck& check, Figure figure) {
  double value = 0;
  for (const StepCheck& step : check.steps) value = std::max(value, step.*figure);
  return value;
}

// "thumb_distal" and "thumb_proximal" become "thumb"; metacarpals of fingers are the palm's.
std::vector<std::string> digits_of(const std::vector<std::string>& bones) {
  std::vector<std::string> digits;
  for (const std::string& bone : bones) {
    std::string digit = bone.substr(0, bone.find('_'));
    if (bone.ends_with("_metacarpal") && digit != "thumb") digit = "palm";
    if (std::find(digits.begin(), digits.end(), digit) == digits.end()) digits.push_back(digit);
  }
  return digits;
}

// Along the object's own axes.
Eigen::Vector3d size_mm(const Grasp& grasp) {
  return 2000 * grasp.object->half_extents();
}

void add_failures(std::string& out, const GraspCheck& check) {
  for (const std::string& failure : check.failures) append(out, "         {}\n", failure);
}

void add_unnamed(std::string& out, const GraspCheck& check) {
  if (!check.missing_digits.empty()) {
    append(out, "         the taxonomy names {}, which do not touch\n",
           fmt::join(check.missing_digits, ", "));
  }
  if (!check.extra_digits.empty()) {
    append(out, "         {} also touch, which the taxonomy does not name\n",
           fmt::join(check.extra_digits, ", "));
  }
}

}  // namespace

nlohmann::json check_json(const Grasp& grasp, const Hand& hand, const GraspCheck& check) {
  nlohmann::json steps = nlohmann::json::array();
  for (const StepCheck& step : check.steps) {
    steps.push_back({{"step", step.step},
                     {"penetration_mm", step.penetration_mm},
                     {"volume_cm3", step.volume_cm3},
                     {"self_penetration_mm", step.self_penetration_mm},
                     {"crossing_mm", step.crossing_mm},
                     {"crossed", step.crossed},
                     {"contacts", step.contacts},
                     {"at_limits", step.at_limits},
                     {"clearance_mm", step.clearance_mm}});
  }
  const Eigen::Vector3d size = size_mm(grasp);
  return {{"id", grasp.id},
          {"object_size_mm", {size.x(), size.y(), size.z()}},
          {"name", grasp.name},
          {"hand", hand.name},
          {"pass", check.pass},
          {"failures", check.failures},
          {"missing_digits", check.missing_digits},
          {"extra_digits", check.extra_digits},
          {"steps", steps}};
}

std::string summary_table(const std::vector<Grasp>& grasps, const std::vector<GraspCheck>& checks) {
  std::string out;
  append(out, "{:36} {:>8} {:>7} {:>7} {:>7} {:>7}\n", "", "in each", "volume", "overlap", "clear",
         "closed");
  append(out, "{:36} {:>8} {:>7} {:>7} {:>7} {:>7}\n", "grasp", "other mm", "cm3", "mm", "mm",
         "touching");
  for (std::size_t i = 0; i < grasps.size(); ++i) {
    const GraspCheck& check = checks[i];
    append(out, "{} {:3} {:27} {:8.1f} {:7.2f} {:7.1f} {:7.1f} {}\n", check.pass ? "ok  " : "FAIL",
           grasps[i].id, grasps[i].name, worst(check, &StepCheck::penetration_mm),
           worst(check, &StepCheck::volume_cm3), worst(check, &StepCheck::self_penetration_mm),
           check.steps.front().clearance_mm,
           fmt::join(digits_of(check.steps.back().contacts), " "));
    add_failures(out, check);
    add_unnamed(out, check);
  }
  return out;
}

std::string step_table(const Grasp& grasp, const GraspCheck& check) {
  std::string out;
  append(out, "{} {:3} {}: {}\n", check.pass ? "ok  " : "FAIL", grasp.id, grasp.name,
         grasp.object_name);
  const Eigen::Vector3d size = size_mm(grasp);
  append(out, "         the object's x, y and z: {:.1f} x {:.1f} x {:.1f} mm\n", size.x(), size.y(),
         size.z());
  append(out, "{:>14} {:>8} {:>7} {:>7} {:>7} {:>7}\n", "", "in each", "volume", "overlap", "clear",
         "crossed");
  append(out, "{:>14} {:>8} {:>7} {:>7} {:>7} {:>7}\n", "step", "other mm", "cm3", "mm", "mm",
         "mm");
  for (const StepCheck& step : check.steps) {
    append(out, "{:14} {:8.1f} {:7.2f} {:7.1f} {:7.1f} {:7.1f}\n", step.step, step.penetration_mm,
           step.volume_cm3, step.self_penetration_mm, step.clearance_mm, step.crossing_mm);
  }
  const StepCheck& closed = check.steps.back();
  append(out, "         touching: {}\n", fmt::join(closed.contacts, " "));
  if (!closed.at_limits.empty()) {
    append(out, "         at their limits: {}\n", fmt::join(closed.at_limits, " "));
  }
  add_failures(out, check);
  add_unnamed(out, check);
  return out;
}

}  // namespace graspdb
