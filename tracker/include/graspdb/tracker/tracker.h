// SPDX-License-Identifier: MIT
// Reads a hand's pose from one frame and the previous state: Romero, Kjellstroem and Kragic, "Hands
// in Action" (ICRA 2010).
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "graspdb/core/camera.h"
#include "graspdb/core/image.h"
#include "graspdb/database/database.h"
#include "graspdb/database/search.h"
#include "graspdb/hand/skeleton.h"
#include "graspdb/tracker/describer.h"
#include "graspdb/tracker/pose_vector.h"

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

// No value is right for every temporal model: start from tuned_options(). What is left at 0 is
// refused, but for roll_deg, merge_deg and reach.
struct TrackerOptions {
  TemporalModel temporal = TemporalModel::kKde;
  int neighbors = 0;     // k, of each look at a frame, 1..1000
  double roll_deg = 0;   // a frame is looked at as it is and rolled by so much either way, 0..90;
                         // 0: as it is alone
  int kept = 0;          // hypotheses, the heaviest, that the next frame remembers, 1..1000
  double sigma_hog = 0;  // of the descriptor distance (a row's 255 counts as 1), .01..100
  double sigma_stretch = 0;  // of the logarithm of the box's aspect ratio over the row's, .01..100
  double sigma_arm_deg = 0;  // of the arm's direction in the picture, 1..1000
  double sigma_pose = 0;     // of the pose vector around the previous answer, .01..100
  double bandwidth = 0;      // of the pose vector around each previous hypothesis, .01..100
  double merge_deg = 0;  // the answer lies between the hypotheses so near to the heaviest, 0..90;
                         // 0: it is the heaviest alone
  double reach = 0.33;  // the answer is moved by up to so much of the mask's box to cover the mask,
                        // 0..0.35; 0: it stays where its box and the row's agree
  double max_distance = 0;  // a nearest descriptor further away is no hand, .01..1000
};

// What rows are searched by. Distances of the two have nothing in common.
enum class DescriptorKind { kHog, kLearned };
DescriptorKind descriptor_kind(const Database& database);

// As chosen for this temporal model and such rows on the training sequences (docs/tracking.md).
TrackerOptions tuned_options(TemporalModel temporal, DescriptorKind kind);

// One of the numbers among them.
struct TrackerNumber {
  const char* key;    // in files and messages
  const char* names;  // on the command line
  std::variant<int TrackerOptions::*, double TrackerOptions::*> member;
  double low, high;
  const char* help;
  bool tuned = true;  // scripts/tune.py chooses it
};
inline constexpr std::array<TrackerNumber, 11> kTrackerNumbers = {
    {{"neighbours", "-k,--neighbours", &TrackerOptions::neighbors, 1, 1000, "Neighbours looked up"},
     {"roll_deg", "--roll", &TrackerOptions::roll_deg, 0, 90,
      "Frames are looked at rolled by so much either way, too, degrees; 0: not"},
     {"kept", "--kept", &TrackerOptions::kept, 1, 1000, "Hypotheses that the next frame remembers"},
     {"sigma_hog", "--sigma-hog", &TrackerOptions::sigma_hog, 0.01, 100,
      "Of the descriptor distance"},
     {"sigma_stretch", "--sigma-stretch", &TrackerOptions::sigma_stretch, 0.01, 100,
      "Of the box's log aspect ratio against the row's"},
     {"sigma_arm_deg", "--sigma-arm", &TrackerOptions::sigma_arm_deg, 1, 1000,
      "Of the arm's direction in the picture against the row's, degrees"},
     {"sigma_pose", "--sigma-pose", &TrackerOptions::sigma_pose, 0.01, 100,
      "Of the pose around the last answer (gaussian)"},
     {"bandwidth", "--bandwidth", &TrackerOptions::bandwidth, 0.01, 100,
      "Of the pose around each last hypothesis (kde, successors)"},
     {"merge_deg", "--merge", &TrackerOptions::merge_deg, 0, 90,
      "The answer lies between the hypotheses so near to the heaviest, degrees"},
     {"reach", "--reach", &TrackerOptions::reach, 0, 0.35,
      "The answer is moved by up to so much of the mask's box to cover the mask; 0: not", false},
     {"max_distance", "--max-distance", &TrackerOptions::max_distance, 0.01, 1000,
      "A nearest descriptor further away is no hand", false}}};

void set_number(TrackerOptions& options, const TrackerNumber& number, double value);
// Throws Error naming the number that is out of its range.
void check_options(const TrackerOptions& options);

// What is seen in one frame.
struct Observation {
  GrayImage gray;
  Mask hand;  // the visible hand without its forearm, of the same size
  Intrinsics camera;
  double segment_ms = 0;   // what finding it took
  bool colorless = false;  // no hand was found, and there is no colour to find one by
  // From the hand to its arm, in the picture, of length 1; none when no arm is seen.
  std::optional<Eigen::Vector2d> towards_arm = {};
};

struct Hypothesis {
  std::uint32_t row = 0;
  double roll_deg = 0;  // turned by so much, clockwise, the frame looks like the row
  double weight = 0;    // they sum to 1
};

struct StageTimes {  // milliseconds
  double segment = 0, describe = 0, search = 0, temporal = 0;
  double total = 0;  // of all of them and what lies between; the first and this are HandReader's.
                     // To choose between two finders' hands is part of `segment`.
};

// Why a frame has no answer.
enum class NoAnswer {
  kNone,       // it has one
  kNoHand,     // nothing was found
  kUnlike,     // what was found is further than max_distance from all rows
  kNoRowFits,  // no row's hand has such a box
  kTooNear,    // the hand would reach behind the camera
};

// Without a hand `valid` is false and only what was seen and the times mean anything.
struct Estimate {
  bool valid = false;
  NoAnswer no_answer = NoAnswer::kNoHand;  // kNone when valid
  // How likely the rotation is right to 30 degrees, by the distance of the nearest descriptor.
  double confidence = 0;
  // What was seen.
  bool colorless = false;  // HandReader's: no hand, as there is no colour to find it by
  Mask hand;               // HandReader's
  std::optional<Eigen::Vector2d> towards_arm;  // HandReader's; as Observation has it
  bool left_hand = false;                      // HandReader's
  Box box;                                     // of the mask, pixels; empty without one
  DescriptorBytes descriptor;                  // of the mask's pixels; of a left hand in the mirror
  // The answer: the heaviest hypothesis; where some are merged, its pose and place lie between.
  std::uint32_t row = 0;         // without an answer: the nearest, if any
  double roll_deg = 0;           // as Hypothesis has it
  double distance = 0;           // of the nearest descriptor, however the frame is rolled
  int grasp = 0;                 // id, of the row
  double grasp_probability = 0;  // the weight of all hypotheses of that grasp
  int step = 0;
  RigidTransform camera_from_hand;  // its translation is where the wrist is
  JointAngles angles = JointAngles::Zero();
  Keypoints joints = Keypoints::Zero();  // camera frame, metres
  Eigen::Matrix<double, 2, kKeypointCount> joints_px =
      Eigen::Matrix<double, 2, kKeypointCount>::Zero();
  std::vector<Hypothesis> hypotheses;  // all that were weighed, heaviest first
  StageTimes ms;
};

class Successors;

// Of right hands, one video; HandReader is what finds them in its frames. Not thread-safe; database
// and search must outlive it.
class Tracker {
 public:
  // Trackers may share a describer; one that is given none makes its own. Throws Error as
  // check_options and Describer do.
  Tracker(const Database& database, const Search& search, const TrackerOptions& options,
          std::shared_ptr<const Describer> describer = nullptr);
  ~Tracker();
  Tracker(Tracker&&) noexcept;

  // One with the same options that has seen nothing; they share all that is large.
  Tracker beginning() const;

  // Reads the next frame. A mask without a hand gives an invalid estimate and forgets the past.
  // Throws Error for a database whose rows were altered.
  Estimate step(const Observation& seen);
  // The next frame is of another video.
  void forget();

 private:
  struct Look;
  struct Candidate;

  bool read(const Observation& seen, Estimate& estimate);
  std::vector<Look> look_at(const Observation& seen, const Box& box) const;
  void find_neighbors(std::vector<Look>& looks) const;
  void add_successors(Look& look) const;
  static const Neighbor& nearest_of(const std::vector<Look>& looks);
  std::vector<Candidate> look_up(const std::vector<Look>& looks) const;
  std::optional<Candidate> candidate_of(const Neighbor& neighbor, const Look& look) const;
  void check_row(std::uint32_t row) const;
  const Skeleton& skeleton_of(const Candidate& candidate) const;
  void weigh_arms(const Eigen::Vector2d& towards_arm, std::vector<Candidate>& candidates) const;
  double log_prior(const PoseVector& pose) const;
  static void put_heaviest_first(std::vector<Candidate>& candidates);
  void weigh(std::vector<Candidate>& candidates) const;
  static const Look& look_of(const Candidate& candidate, const std::vector<Look>& looks);
  Candidate merged(const std::vector<Candidate>& candidates, const std::vector<Look>& looks) const;
  void lay_over(const Observation& seen, const Box& box, Candidate& best) const;
  void answer(const std::vector<Candidate>& candidates, const Candidate& best,
              const Intrinsics& camera, Estimate& estimate) const;
  void remember(std::vector<Candidate> candidates, const Candidate& best);

  Tracker(const Tracker&);

  const Database& database_;
  const Search& search_;
  TrackerOptions options_;
  std::shared_ptr<const Describer> describer_;
  std::shared_ptr<const Successors> successors_;  // of kSuccessors
  std::vector<Candidate> previous_;               // heaviest first
};

}  // namespace graspdb
