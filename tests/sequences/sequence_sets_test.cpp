// SPDX-License-Identifier: MIT
// The two sets of sequences share nothing with each other, and no pose with the database.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "graspdb/core/file.h"
#include "graspdb/core/transform.h"
#include "graspdb/evaluation/metrics.h"
#include "graspdb/grasps/closing.h"
#include "graspdb/hand/turns.h"
#include "graspdb/sequences/sequence.h"
#include "support/source_folder.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;

using testing::kSource;

struct Set {
  std::vector<SequenceSpec> train, test;

  std::vector<SequenceSpec> all() const {
    std::vector<SequenceSpec> both = train;
    both.insert(both.end(), test.begin(), test.end());
    return both;
  }
};

std::vector<SequenceSpec> load_folder(const fs::path& folder) {
  std::vector<SequenceSpec> specs;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().string().ends_with(".seq.toml")) specs.push_back(load_sequence(entry.path()));
  }
  return specs;
}

const Set& sets() {
  static const Set sets{load_folder(kSource / "sequences/train"),
                        load_folder(kSource / "sequences/test")};
  return sets;
}

std::string hand_name(const SequenceSpec& spec) {
  return spec.hand.file.empty() ? spec.hand.shape.name : spec.hand.file.stem().string();
}

GraspPose closed(const SequenceSpec& spec) {
  const fs::path file = spec.file.parent_path() / "closed" / (hand_name(spec) + ".toml");
  return load_closed_poses(file).poses.at(spec.grasp.id);
}

// Of all frames, by linear interpolation between keyframes.
std::vector<double> closures(const SequenceSpec& spec) {
  std::vector<double> values;
  for (int frame = 0; frame < spec.frame_count(); ++frame) {
    const double time = spec.keyframes.front().time + frame / spec.frames_per_second;
    const auto after =
        std::ranges::find_if(spec.keyframes, [&](const Keyframe& key) { return key.time >= time; });
    if (after == spec.keyframes.begin() || after == spec.keyframes.end()) {
      values.push_back(after == spec.keyframes.end() ? spec.keyframes.back().closure
                                                     : after->closure);
      continue;
    }
    const Keyframe& before = *(after - 1);
    const double share = (time - before.time) / (after->time - before.time);
    values.push_back(before.closure + share * (after->closure - before.closure));
  }
  return values;
}

// Every pose of the default hands' databases.
std::vector<JointAngles> database_poses() {
  const JointAngles rest = load_rest_pose(kSource / "grasps");
  std::vector<JointAngles> poses;
  for (const char* hand : {"male", "female", "slender", "child"}) {
    const ClosedPoses known =
        load_closed_poses(kSource / "grasps/closed" / (std::string(hand) + ".toml"));
    for (const Grasp& grasp : load_grasps(kSource / "grasps")) {
      for (int step = 1; step <= kStepCount; ++step) {
        poses.push_back(pose_at_step(grasp, rest, known.poses.at(grasp.id), step).angles);
      }
    }
  }
  return poses;
}

double nearest_deg(const JointAngles& angles, const std::vector<JointAngles>& poses) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const JointAngles& pose : poses) {
    nearest = std::min(nearest, mean_joint_difference_deg(angles, pose));
  }
  return nearest;
}

TEST(SequenceSets, AreLargeAndLong) {
  EXPECT_GE(sets().train.size(), 20u);
  EXPECT_GE(sets().test.size(), 22u);
  for (const SequenceSpec& spec : sets().all()) EXPECT_GE(spec.frame_count(), 100) << spec.name;
}

TEST(SequenceSets, HaveNamesSeedsAndGraspsOfTheirOwn) {
  std::set<std::string> names;
  std::set<std::uint64_t> seeds;
  std::set<int> grasps;
  for (const SequenceSpec& spec : sets().all()) {
    EXPECT_TRUE(names.insert(spec.name).second) << spec.name;
    EXPECT_TRUE(seeds.insert(spec.seed).second) << spec.name;
    EXPECT_TRUE(grasps.insert(spec.grasp.id).second) << spec.name;
    EXPECT_GT(spec.grasp.id, 33) << spec.name;
  }
}

TEST(SequenceSets, ShareNoHandAndNoObject) {
  for (const SequenceSpec& train : sets().train) {
    for (const SequenceSpec& test : sets().test) {
      EXPECT_NE(hand_name(train), hand_name(test));
      EXPECT_NE(train.grasp.object_name, test.grasp.object_name);
      if (test.hand.file.empty()) {
        const HandShape &a = train.hand.shape, &b = test.hand.shape;
        EXPECT_FALSE(a.length_mm == b.length_mm && a.breadth_mm == b.breadth_mm) << test.name;
      }
    }
  }
}

TEST(SequenceSets, UseNoDefaultHand) {
  for (const SequenceSpec& spec : sets().all()) {
    for (const char* name : {"male", "female", "slender", "child"}) {
      const HandShape known = default_hand_shape(name), &own = spec.hand.shape;
      EXPECT_NE(hand_name(spec), name);
      EXPECT_FALSE(spec.hand.file.empty() && own.length_mm == known.length_mm &&
                   own.breadth_mm == known.breadth_mm)
          << spec.name;
    }
  }
}

TEST(SequenceSets, AFifthHasNoObject) {
  for (const auto& set : {sets().train, sets().test}) {
    const auto bare = std::ranges::count(set, false, &SequenceSpec::object_visible);
    EXPECT_NEAR(static_cast<double>(bare) / static_cast<double>(set.size()), 0.2, 0.03);
  }
}

TEST(SequenceSets, ShareNoPose) {
  for (const SequenceSpec& train : sets().train) {
    const JointAngles known = closed(train).angles;
    for (const SequenceSpec& test : sets().test)
      EXPECT_GE(mean_joint_difference_deg(closed(test).angles, known), 5)
          << train.name << ", " << test.name;
  }
}

// Of one thing over all sequences of a set.
struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

double turn_deg_per_second(const SequenceSpec& spec) {
  const std::vector<Keyframe>& keys = spec.keyframes;
  double turn_deg = 0;
  for (std::size_t i = 1; i < keys.size(); ++i)
    turn_deg +=
        rotation_deg(rotation_from_turns(keys[i - 1].view), rotation_from_turns(keys[i].view));
  return turn_deg / (keys.back().time - keys.front().time);
}

TEST(SequenceSets, SpreadOverForearmLensDistanceWristAndSpeed) {
  for (const auto& set : {sets().train, sets().test}) {
    Range forearm_m, focal_px, distance_m, wrist_deg, speed;
    for (const SequenceSpec& spec : set) {
      forearm_m.add(spec.visible_forearm);
      focal_px.add(spec.camera.fx);
      speed.add(turn_deg_per_second(spec));
      for (const Keyframe& key : spec.keyframes) {
        distance_m.add(key.palm.norm());
        wrist_deg.add(degrees(key.wrist.minCoeff()));
        wrist_deg.add(degrees(key.wrist.maxCoeff()));
      }
    }
    EXPECT_EQ(forearm_m.low, 0);
    EXPECT_EQ(forearm_m.high, 0.2);
    EXPECT_GT(focal_px.high, 2 * focal_px.low);
    EXPECT_GT(distance_m.high, 2.5 * distance_m.low);
    EXPECT_GE(wrist_deg.low, -40.001);
    EXPECT_LE(wrist_deg.high, 40.001);
    EXPECT_GT(wrist_deg.high - wrist_deg.low, 70);
    EXPECT_GT(speed.high, 2.5 * speed.low);
  }
}

TEST(SequenceSets, NinetyPercentOfGraspingFramesAreFiveDegreesFromTheDatabase) {
  const std::vector<JointAngles> known = database_poses();
  for (const SequenceSpec& spec : sets().all()) {
    const GraspPose end = closed(spec);
    int grasping = 0, far = 0;
    for (const double closure : closures(spec)) {
      if (closure < 0.5) continue;
      const int step = static_cast<int>(std::lround(1000 * closure));
      const JointAngles angles = pose_at_step(spec.grasp, spec.rest, end, step, 1000).angles;
      ++grasping;
      far += nearest_deg(angles, known) >= 5;
    }
    EXPECT_GE(far, 0.9 * grasping) << spec.name;
    EXPECT_GT(grasping, 20) << spec.name;
  }
}

}  // namespace
}  // namespace graspdb
