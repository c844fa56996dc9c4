// SPDX-License-Identifier: MIT
// Gates and verdicts of the lines of hand_check.h.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "graspdb/hand/check/hand_check.h"
#include "graspdb/hand/digits.h"

namespace graspdb {

struct Gate {
  double low, high;  // both allowed
  std::string text;
};
Gate at_most(double high);
Gate at_least(double low);
Gate above(double low);
Gate between(double low, double high);
Gate exactly(double value);

// A value that is not a number fails.
HandCheckLine judged(const std::string& name, double value, const std::string& unit,
                     const Gate& gate, const std::string& why = "");
HandCheckLine not_applicable(const std::string& name, const std::string& unit, const Gate& gate,
                             const std::string& why);

bool moves_skin(const Hand& hand, int bone);
std::string no_skin_on(int bone);  // "index_distal moves no skin"

// The angles that are judged together.
struct AngleGroup {
  const char* name;
  int first, end;
};
constexpr AngleGroup kAngleGroups[] = {{"wrist", kWristFlexion, kThumbCmcFlexion},
                                       {"thumb", kThumbCmcFlexion, kFirstFingerAngle},
                                       {"fingers", kFirstFingerAngle, kAngleCount}};

// One angle at one end of its range, all others at zero.
struct Limit {
  int angle;
  double value;  // radians

  JointAngles angles() const;
  std::string text() const;  // "index_mcp_flexion 95 deg"
};
std::vector<Limit> limits_of(const AngleGroup& group);

// The largest value and where it was found; one that is not a number stays.
struct Worst {
  double value = 0;
  std::string where;

  void take(double other, const auto& name_of_place) {
    if (!(other > value) && !std::isnan(other)) return;
    value = other;
    where = name_of_place();
  }
};

// The bones without which a line says less than its name.
class Missing {
 public:
  // Notes the bone when it moves no skin, and says so.
  bool lacks_skin(const Hand& hand, int bone);
  const std::string& what() const { return what_; }

 private:
  std::string what_;
};

// A line whose parts that could be measured pass is not applicable when others are missing.
HandCheckLine judged_unless(const Missing& missing, const std::string& name, const Worst& worst,
                            const std::string& unit, const Gate& gate);

}  // namespace graspdb
