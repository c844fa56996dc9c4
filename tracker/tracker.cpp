// SPDX-License-Identifier: MIT
#include "graspdb/tracker/tracker.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "candidate.h"
#include "graspdb/core/error.h"
#include "graspdb/core/stopwatch.h"
#include "graspdb/features/hog.h"
#include "graspdb/hand/label.h"
#include "roll.h"
#include "silhouette.h"
#include "successors.h"

namespace graspdb {
namespace {

// A box twice as wide for its height as the row's shows no hand in the row's pose.
const double kLargestStretch = std::log(2.0);

// How often answers of the training sequences are right to 30 degrees, by the distance of the
// nearest descriptor: scripts/fit_confidence.py drew the curve through them. Of codes through those
// of rendered frames (alpha 0 and 2 %) and of photoreal ones, of HOGs through the former.
double confidence_at(double distance, DescriptorKind kind) {
  struct Curve {
    double half, width;
  };
  const Curve curve = kind == DescriptorKind::kHog ? Curve{3.9, 1.2} : Curve{0.38, 0.04};
  return 1 / (1 + std::exp((distance - curve.half) / curve.width));
}

// As the frame's camera sees what a rolled one does.
Placement rolled_back(const Placement& placement, double roll_deg) {
  const Eigen::Matrix3d back = camera_from_rolled(roll_deg);
  return {back * placement.camera_from_row_camera, back * placement.palm_center};
}

// The middles of a hand and its arm, as far as they are seen most often: metres beyond the wrist,
// and in the hand frame.
constexpr double kArmPoint = 0.06;
const Eigen::Vector3d kHandPoint(0, 0.06, 0);

constexpr std::size_t kCacheLine = 64;  // bytes

// Labels lie all over the file: the processor fetches them side by side, not one after the other.
void fetch_labels(const Database& database, const std::vector<Neighbor>& neighbors) {
  for (const Neighbor& neighbor : neighbors) {
    const auto label = std::as_bytes(database.label(neighbor.row));
    for (std::size_t at = 0; at < label.size(); at += kCacheLine) __builtin_prefetch(&label[at]);
    __builtin_prefetch(&label.back());
  }
}

}  // namespace

Tracker::Tracker(const Database& database, const Search& search, const TrackerOptions& options,
                 std::shared_ptr<const Describer> describer)
    : database_(database),
      search_(search),
      options_(options),
      describer_(describer ? std::move(describer) : std::make_shared<Describer>(database)) {
  check_options(options);
  if (options.temporal == TemporalModel::kSuccessors)
    successors_ = std::make_shared<Successors>(database);
}

Tracker::~Tracker() = default;
Tracker::Tracker(Tracker&&) noexcept = default;
Tracker::Tracker(const Tracker&) = default;

Tracker Tracker::beginning() const {
  Tracker tracker(*this);
  tracker.forget();
  return tracker;
}

Estimate Tracker::step(const Observation& seen) {
  Estimate estimate;
  if (!read(seen, estimate)) forget();
  return estimate;
}

void Tracker::forget() {
  previous_.clear();
}

// False, with `estimate` as far as it is known, when there is no hand.
bool Tracker::read(const Observation& seen, Estimate& estimate) {
  Stopwatch watch;
  const std::optional<Box> box = tight_box(seen.hand);
  if (!box) return false;
  estimate.box = *box;
  std::vector<Look> looks = look_at(seen, *box);
  estimate.descriptor = looks.front().code;
  estimate.ms.describe = watch.lap_ms();
  find_neighbors(looks);
  estimate.ms.search = watch.lap_ms();
  if (looks.front().neighbors.empty()) return false;
  const Neighbor& nearest = nearest_of(looks);
  check_row(nearest.row);
  estimate.row = nearest.row;
  estimate.distance = descriptor_distance(nearest);
  estimate.confidence = confidence_at(estimate.distance, descriptor_kind(database_));
  estimate.no_answer = NoAnswer::kUnlike;
  if (estimate.distance > options_.max_distance) return false;
  std::vector<Candidate> candidates = look_up(looks);
  estimate.no_answer = NoAnswer::kNoRowFits;
  if (candidates.empty()) return false;
  if (seen.towards_arm) weigh_arms(*seen.towards_arm, candidates);
  weigh(candidates);
  Candidate best = merged(candidates, looks);
  if (options_.reach > 0) lay_over(seen, *box, best);
  answer(candidates, best, seen.camera, estimate);
  remember(std::move(candidates), best);
  estimate.ms.temporal = watch.lap_ms();
  return true;
}

// As it is first. Rows are a few views of many: what errs for the hand as it stands in the frame
// errs otherwise for the same hand turned, and what looks agree on is nearer the truth.
std::vector<Tracker::Look> Tracker::look_at(const Observation& seen, const Box& box) const {
  std::vector<Look> looks{{0, seen.camera, box, describer_->describe(seen.gray, seen.hand), {}}};
  if (options_.roll_deg == 0) return looks;
  for (const double roll_deg : {options_.roll_deg, -options_.roll_deg}) {
    const Observation turned = rolled(seen, box, roll_deg);
    const std::optional<Box> turned_box = tight_box(turned.hand);
    if (!turned_box) continue;  // of a pixel or two, none was hit
    looks.push_back(
        {roll_deg, turned.camera, *turned_box, describer_->describe(turned.gray, turned.hand), {}});
  }
  return looks;
}

// The nearest rows, and what the last hypotheses may have become; nearest first, ties by row.
void Tracker::find_neighbors(std::vector<Look>& looks) const {
  std::vector<DescriptorView> codes;
  for (const Look& look : looks) codes.emplace_back(look.code);
  std::vector<std::vector<Neighbor>> found = search_.nearest_of_each(codes, options_.neighbors);
  for (std::size_t i = 0; i < looks.size(); ++i) {
    looks[i].neighbors = std::move(found[i]);
    if (successors_ && !previous_.empty()) add_successors(looks[i]);
  }
}

void Tracker::add_successors(Look& look) const {
  std::vector<std::uint32_t> rows;
  for (const Candidate& before : previous_) {
    if (before.roll_deg == look.roll_deg) successors_->append(before.row, rows);
  }
  for (const Neighbor& neighbor : look.neighbors) rows.push_back(neighbor.row);
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  look.neighbors = measure(database_, look.code, rows);
  std::stable_sort(
      look.neighbors.begin(), look.neighbors.end(),
      [](const Neighbor& a, const Neighbor& b) { return a.squared_distance < b.squared_distance; });
}

// Opening a database checks its header only; what is used of its content is checked here.
void Tracker::check_row(std::uint32_t row) const {
  const DatabaseInfo& info = database_.info();
  const bool known =
      database_.hand(row) < info.hands.size() && database_.variant(row) < info.variants.size();
  if (is_finite(database_.label(row)) && known) return;
  throw Error({database_.path().string(), fmt::format("row {}", row),
               "finite labels, a hand and a variant of the header",
               "an altered row: see `graspdb verify`"});
}

const Neighbor& Tracker::nearest_of(const std::vector<Look>& looks) {
  const auto distance = [](const Look& look) { return look.neighbors.front().squared_distance; };
  return std::ranges::min_element(looks, {}, distance)->neighbors.front();
}

// The neighbours' poses as the frame's camera would see them, weighted by the observation.
std::vector<Tracker::Candidate> Tracker::look_up(const std::vector<Look>& looks) const {
  std::vector<Candidate> candidates;
  for (const Look& look : looks) {
    fetch_labels(database_, look.neighbors);
    for (const Neighbor& neighbor : look.neighbors) {
      check_row(neighbor.row);
      if (std::optional<Candidate> candidate = candidate_of(neighbor, look))
        candidates.push_back(std::move(*candidate));
    }
  }
  return candidates;
}

// None of a row whose hand is wholly hidden, or far from what is seen in its box.
std::optional<Tracker::Candidate> Tracker::candidate_of(const Neighbor& neighbor,
                                                        const Look& look) const {
  const BoxTangents row_box = database_.box(neighbor.row);
  if (!(row_box.width > 0 && row_box.height > 0)) return std::nullopt;
  const double stretch = log_stretch(look.box, look.camera, row_box);
  if (std::abs(stretch) > kLargestStretch) return std::nullopt;
  const LabelPose row = unpack_label(database_.label(neighbor.row));
  Candidate candidate{.row = neighbor.row, .roll_deg = look.roll_deg, .angles = row.angles};
  candidate.placement = rolled_back(
      place(look.box, look.camera, row_box, database_.info().camera_distance), look.roll_deg);
  candidate.rotation = candidate.placement.camera_from_row_camera * row.rotation;
  candidate.pose = pose_vector(candidate.rotation, row.angles);
  const double distance = descriptor_distance(neighbor);
  candidate.log_weight = -distance * distance / (2 * options_.sigma_hog * options_.sigma_hog) -
                         stretch * stretch / (2 * options_.sigma_stretch * options_.sigma_stretch);
  return candidate;
}

const Skeleton& Tracker::skeleton_of(const Candidate& candidate) const {
  return database_.info().hands[database_.hand(candidate.row)].skeleton;
}

// By the direction of their own forearm in the picture, as far as it is seen from the side.
void Tracker::weigh_arms(const Eigen::Vector2d& towards_arm,
                         std::vector<Candidate>& candidates) const {
  const double sigma = radians(options_.sigma_arm_deg);
  for (Candidate& candidate : candidates) {
    const Skeleton& skeleton = skeleton_of(candidate);
    const Eigen::Vector3d arm =
        candidate.rotation * (forearm_point(skeleton, candidate.angles, kArmPoint) - kHandPoint);
    // As seen from the camera, in which the hand may be far from the axis.
    const Eigen::Vector3d& hand = candidate.placement.palm_center;
    const Eigen::Vector2d seen = arm.head<2>() - hand.head<2>() * (arm.z() / hand.z());
    // For small angles a Gaussian's logarithm.
    const double across = 1 - seen.normalized().dot(towards_arm);
    candidate.log_weight -= across * std::min(seen.norm() / arm.norm(), 1.0) / (sigma * sigma);
  }
}

// Boxes agree only roughly: an object hides other parts of the hand than of the row's.
void Tracker::lay_over(const Observation& seen, const Box& box, Candidate& best) const {
  const Skeleton& skeleton = skeleton_of(best);
  const Keypoints in_hand = keypoints_in_hand(skeleton, best.angles);
  const PosedHand hand{best.rotation * (in_hand.colwise() - palm_center(in_hand)),
                       hand_length(skeleton)};
  best.placement.palm_center =
      laid_over(seen.hand, box, seen.camera, hand, best.placement.palm_center, options_.reach);
}

void Tracker::answer(const std::vector<Candidate>& candidates, const Candidate& best,
                     const Intrinsics& camera, Estimate& estimate) const {
  const Skeleton& skeleton = skeleton_of(best);
  estimate.row = best.row;
  estimate.roll_deg = best.roll_deg;
  estimate.grasp = database_.grasp(best.row);
  estimate.step = database_.step(best.row);
  estimate.angles = best.angles;
  estimate.hypotheses.reserve(candidates.size());
  for (const Candidate& candidate : candidates) {
    estimate.hypotheses.push_back({candidate.row, candidate.roll_deg, candidate.weight});
    if (database_.grasp(candidate.row) == estimate.grasp)
      estimate.grasp_probability += candidate.weight;
  }
  const Eigen::Vector3d wrist =
      best.placement.palm_center - best.rotation * palm_center(skeleton, best.angles);
  estimate.camera_from_hand = {best.rotation, wrist};
  estimate.joints = (best.rotation * keypoints_in_hand(skeleton, best.angles)).colwise() + wrist;
  // A box that fills the frame can put joints behind the camera: then nothing is known.
  estimate.valid = estimate.joints.row(2).minCoeff() > kNearestDepth;
  estimate.no_answer = estimate.valid ? NoAnswer::kNone : NoAnswer::kTooNear;
  for (int i = 0; i < kKeypointCount; ++i)
    estimate.joints_px.col(i) = camera.project(estimate.joints.col(i));
}

void Tracker::remember(std::vector<Candidate> candidates, const Candidate& best) {
  const auto kept = std::min(candidates.size(), static_cast<std::size_t>(options_.kept));
  candidates.resize(kept);
  if (options_.temporal == TemporalModel::kGaussian) candidates = {best};
  previous_ = std::move(candidates);
}

}  // namespace graspdb
