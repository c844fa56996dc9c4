// SPDX-License-Identifier: MIT
// Reads a hand's pose from one frame and the previous state: Romero, Kjellstroem and Kragic, "Hands
// in Action" (ICRA 2010).
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "graspdb/camera.h"
#include "graspdb/database.h"
#include "graspdb/hog.h"
#include "graspdb/image.h"
#include "graspdb/pose_vector.h"
#include "graspdb/search.h"
#include "graspdb/skeleton.h"

namespace graspdb {

// How a frame depends on the one before.
enum class TemporalModel {
  kNone,      // not at all
  kGaussian,  // around the previous answer: a single hypothesis
  kKde,       // around all previous hypotheses: a kernel density estimate
  // As kKde; and what each previous hypothesis may have become is weighed too, whether the search
  // finds it or not: the same grasp at a step and from a view next to its own.
  kSuccessors,
};

inline constexpr std::array kTemporalModels = {TemporalModel::kNone, TemporalModel::kGaussian,
                                               TemporalModel::kKde, TemporalModel::kSuccessors};
std::string temporal_name(TemporalModel model);             // "none", "gaussian", ...
TemporalModel temporal_from_name(const std::string& name);  // throws Error

struct TrackerOptions {
  TemporalModel temporal = TemporalModel::kKde;
  int neighbours = 20;          // k, 1..1000
  int kept = 20;                // hypotheses, the heaviest, that the next frame remembers, 1..1000
  double sigma_hog = 1;         // of the descriptor distance (a row's 255 counts as 1)
  double sigma_stretch = 0.15;  // of the logarithm of the box's aspect ratio over the row's
  double sigma_pose = 0.5;      // of the pose vector around the previous answer
  double bandwidth = 0.5;       // of the pose vector around each previous hypothesis
  double max_distance = 5;      // a nearest descriptor further away is no hand
  bool left_hand = false;       // the frame is mirrored on the way in, the answer on the way out
};

// As chosen for this temporal model on the training sequences (docs/tracking.md).
TrackerOptions tuned_options(TemporalModel temporal);

// What the tracker is shown: one segmented frame.
struct Observation {
  const GrayImage& gray;
  const Mask& hand;  // the visible hand, of the same size
  Intrinsics camera;
};

struct Hypothesis {
  std::uint32_t row = 0;
  double weight = 0;  // they sum to 1
};

struct StageTimes {  // milliseconds
  double describe = 0, search = 0, temporal = 0;
};

// Without a hand `valid` is false and only box and times mean anything.
struct Estimate {
  bool valid = false;
  // How likely the rotation is right to 30 degrees, by the distance of the nearest descriptor.
  double confidence = 0;
  Box box;                       // of the mask, pixels; empty without one
  std::uint32_t row = 0;         // the heaviest hypothesis
  double distance = 0;           // of the nearest descriptor
  int grasp = 0;                 // id, of the row
  double grasp_probability = 0;  // the weight of all hypotheses of that grasp
  int step = 0;
  Eigen::Matrix3d camera_from_hand = Eigen::Matrix3d::Identity();
  Eigen::Vector3d wrist = Eigen::Vector3d::Zero();  // camera frame, metres
  JointAngles angles = JointAngles::Zero();
  Keypoints joints = Keypoints::Zero();  // camera frame, metres
  Eigen::Matrix<double, 2, kKeypointCount> joints_px =
      Eigen::Matrix<double, 2, kKeypointCount>::Zero();
  std::vector<Hypothesis> hypotheses;  // all that were weighed, heaviest first
  StageTimes ms;
};

class Successors;

// Throws Error for a database whose rows were altered. Not thread-safe; database and search must
// outlive it.
class Tracker {
 public:
  Tracker(const Database& database, const Search& search, const TrackerOptions& options);
  ~Tracker();
  Tracker(Tracker&&) noexcept;

  // Reads the next frame. A mask without a hand gives an invalid estimate and forgets the past.
  Estimate step(const Observation& observation);
  void forget() { previous_.clear(); }

 private:
  struct Candidate {
    std::uint32_t row = 0;
    Eigen::Matrix3d camera_from_hand;
    PoseVector pose;
    double log_weight = 0;
    double weight = 0;
  };

  Estimate step_right(const Observation& observation);
  std::vector<Neighbor> neighbours_of(const Descriptor& query) const;
  std::vector<Candidate> look_up(const std::vector<Neighbor>& neighbours, const Observation& seen,
                                 const Box& box) const;
  void check_row(std::uint32_t row) const;
  double log_prior(const PoseVector& pose) const;
  void weigh(std::vector<Candidate>& candidates) const;
  void describe_best(const std::vector<Candidate>& candidates, const Observation& seen,
                     Estimate& estimate) const;

  const Database& database_;
  const Search& search_;
  TrackerOptions options_;
  HogOptions hog_;
  std::unique_ptr<const Successors> successors_;  // of kSuccessors
  std::vector<Candidate> previous_;               // heaviest first
};

}  // namespace graspdb
