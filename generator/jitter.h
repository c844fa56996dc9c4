// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "graspdb/core/random.h"
#include "graspdb/generator/build_config.h"
#include "graspdb/hand/angles.h"

namespace graspdb {

// As a configuration states it.
nlohmann::json jitter_json(const Jitter& jitter);

// How one copy of a grasp on a hand is varied. All but the light is drawn once for all steps and
// for held and free rows, so that the steps stay one movement of one person and the variants pairs.
// A draw depends on the seed and on what it is of, by name: neither on what else is built nor on
// any other amplitude.
class JitterDraw {
 public:
  JitterDraw(const Jitter& jitter, const std::string& hand, int grasp, int copy);

  // Each angle drawn evenly from those within the amplitude that a hand can reach.
  JointAngles angles(const JointAngles& stated) const;
  double object_scale() const;
  double visible_forearm(double stated) const;  // metres, at least 0
  Light light(const Light& stated, std::size_t view) const;

 private:
  RandomStream stream(const std::string& purpose) const;

  const Jitter jitter_;
  const std::string key_;
};

}  // namespace graspdb
