// SPDX-License-Identifier: MIT
// Closes a hand on an object by contact, and checks the result.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "graspdb/grasps/grasp.h"
#include "graspdb/hand/hand.h"

namespace graspdb {

// The grasp with its object in the size that it has in this hand.
Grasp fitted_to(const Hand& hand, Grasp grasp);

// Searches placement and angles near grasp.start. Deterministic, thread-safe. Takes seconds.
GraspPose close_grasp(const Grasp& grasp, const Hand& hand);

struct StepCheck {
  int step = 0;
  // Deepest, of hand samples in the object and of object samples in the hand.
  double penetration_mm = 0;
  double volume_cm3 = 0;              // that hand and object share
  double self_penetration_mm = 0;     // deepest overlap between different digits
  double clearance_mm = 0;            // from the hand's skin to the object, 0 when they touch
  std::vector<std::string> contacts;  // bones with skin within 2 mm of the object
  // How far skin stands out on the other side of the object, here or since the step before.
  double crossing_mm = 0;
  std::vector<std::string> crossed;    // the digits that do
  std::vector<std::string> at_limits;  // angles within half a degree of an end of their range
};

struct GraspCheck {
  bool pass = false;
  std::vector<std::string> failures;  // one text a broken gate, with figures
  // Closed: virtual fingers of the taxonomy that do not touch, and digits that touch and are none.
  std::vector<std::string> missing_digits, extra_digits;
  std::vector<StepCheck> steps;
};

// The gates: at every step penetration and overlap of at most 2 mm, and no skin more than 0.2 mm
// beyond what it must not pass; clear of the object at step 1; closed, every required digit within
// 2 mm of the object, in a side grasp with the named side, and no free one; every angle within its
// range. Thread-safe.
GraspCheck check_grasp(const Grasp& grasp, const Hand& hand, const JointAngles& rest,
                       const GraspPose& closed);

// The committed closed poses of one hand: grasps/closed/<hand>.toml beside the grasp files, by
// grasp id.
struct ClosedPoses {
  std::string hand;
  double hand_length = 0;  // metres; tells a hand of the same name from another
  std::map<int, GraspPose> poses;
  std::map<int, std::string> grasp_hashes;  // of the grasp files that were closed
};
ClosedPoses load_closed_poses(const std::filesystem::path& file);
void save_closed_poses(const std::filesystem::path& file, const ClosedPoses& closed);
std::filesystem::path closed_poses_file(const Grasp& grasp, const Hand& hand);
// Adds one pose a grasp to the file that lies beside the first one, in the place of those of a hand
// of another length. Gives the file's name.
std::filesystem::path keep_closed_poses(const std::vector<Grasp>& grasps, const Hand& hand,
                                        const std::vector<GraspPose>& poses);

// Of the grasp file, and of its object's mesh file, as they are now.
std::string grasp_hash(const Grasp& grasp);

// The committed pose when it was closed on this hand from this very grasp file, else the hand is
// closed here and now. Thread-safe.
GraspPose closed_pose(const Grasp& grasp, const Hand& hand);

}  // namespace graspdb
