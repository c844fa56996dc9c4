// SPDX-License-Identifier: MIT
#include "graspdb/tracker.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "graspdb/error.h"
#include "graspdb/hog.h"
#include "graspdb/stopwatch.h"
#include "mirror.h"
#include "placement.h"
#include "successors.h"

namespace graspdb {
namespace {

// A box twice as wide for its height as the row's shows no hand in the row's pose.
constexpr double kNearestJoint = 0.02;  // metres before the camera
const double kLargestStretch = std::log(2.0);

double descriptor_distance(const Neighbor& neighbour) {
  return std::sqrt(static_cast<double>(neighbour.squared_distance)) / 255;
}

// How often answers of the training sequences (alpha 0 and 2 %) are right to 30 degrees, by the
// distance of the nearest descriptor: scripts/fit_confidence.py drew the curve through them.
double confidence_at(double distance) {
  constexpr double kHalf = 3.9, kWidth = 1.2;
  return 1 / (1 + std::exp((distance - kHalf) / kWidth));
}

}  // namespace

Tracker::Tracker(const Database& database, const Search& search, const TrackerOptions& options)
    : database_(database),
      search_(search),
      options_(options),
      hog_(hog_from_name(database.info().hog, database.path().string())) {
  GRASPDB_CHECK(options.neighbours >= 1 && options.kept >= 1 && options.sigma_hog > 0 &&
                options.sigma_pose > 0 && options.bandwidth > 0 && options.max_distance > 0);
  if (options.temporal == TemporalModel::kSuccessors)
    successors_ = std::make_unique<Successors>(database);
}

Tracker::~Tracker() = default;
Tracker::Tracker(Tracker&&) noexcept = default;

Estimate Tracker::step(const Observation& observation) {
  if (!options_.left_hand) return step_right(observation);
  const GrayImage gray = mirrored(observation.gray);
  const Mask hand = mirrored(observation.hand);
  return mirrored(step_right({gray, hand, mirrored(observation.camera)}), gray.width());
}

Estimate Tracker::step_right(const Observation& seen) {
  Estimate estimate;
  Stopwatch watch;
  const auto box = tight_box(seen.hand);
  if (!box) {
    forget();
    return estimate;
  }
  estimate.box = *box;
  const Descriptor query = describe(seen.gray, seen.hand, hog_);
  estimate.ms.describe = watch.lap_ms();
  const std::vector<Neighbor> neighbours = neighbours_of(query);
  estimate.ms.search = watch.lap_ms();
  if (neighbours.empty()) {
    forget();
    return estimate;
  }
  estimate.distance = descriptor_distance(neighbours.front());
  estimate.confidence = confidence_at(estimate.distance);
  if (estimate.distance > options_.max_distance) {
    forget();
    return estimate;
  }
  std::vector<Candidate> candidates = look_up(neighbours, seen, *box);
  if (candidates.empty()) {
    forget();
    return estimate;
  }
  weigh(candidates);
  describe_best(candidates, seen, estimate);
  if (candidates.size() > static_cast<std::size_t>(options_.kept))
    candidates.resize(static_cast<std::size_t>(options_.kept));
  previous_ = std::move(candidates);
  estimate.ms.temporal = watch.lap_ms();
  return estimate;
}

// The nearest rows, and what the last hypotheses may have become; nearest first, ties by row.
std::vector<Neighbor> Tracker::neighbours_of(const Descriptor& query) const {
  std::vector<Neighbor> found = search_.nearest(query, options_.neighbours);
  if (!successors_ || previous_.empty()) return found;
  std::vector<std::uint32_t> rows;
  for (const Candidate& before : previous_) successors_->append(before.row, rows);
  for (const Neighbor& neighbour : found) rows.push_back(neighbour.row);
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  std::vector<Neighbor> all = measure(database_, query, rows);
  std::stable_sort(all.begin(), all.end(), [](const Neighbor& a, const Neighbor& b) {
    return a.squared_distance < b.squared_distance;
  });
  return all;
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

// The neighbours' poses as this camera would see them, weighted by the observation.
std::vector<Tracker::Candidate> Tracker::look_up(const std::vector<Neighbor>& neighbours,
                                                 const Observation& seen, const Box& box) const {
  std::vector<Candidate> candidates;
  const double nearest = neighbours.front().squared_distance;
  for (const Neighbor& neighbour : neighbours) {
    check_row(neighbour.row);
    const BoxTangents row_box = database_.box(neighbour.row);
    // A row whose hand is wholly hidden answers nothing.
    if (!(row_box.width > 0 && row_box.height > 0)) continue;
    const double stretch = log_stretch(box, seen.camera, row_box);
    if (std::abs(stretch) > kLargestStretch) continue;
    const auto label = database_.label(neighbour.row);
    const Placement placed =
        place(box, seen.camera, database_.box(neighbour.row), database_.info().camera_distance);
    Candidate candidate{.row = neighbour.row};
    candidate.camera_from_hand = placed.camera_from_row_camera * label_rotation(label);
    candidate.pose = pose_vector(candidate.camera_from_hand, label_angles(label));
    const double further = (neighbour.squared_distance - nearest) / (255.0 * 255.0);
    candidate.log_weight =
        -further / (2 * options_.sigma_hog * options_.sigma_hog) -
        stretch * stretch / (2 * options_.sigma_stretch * options_.sigma_stretch);
    candidates.push_back(std::move(candidate));
  }
  return candidates;
}

void Tracker::describe_best(const std::vector<Candidate>& candidates, const Observation& seen,
                            Estimate& estimate) const {
  const Candidate& best = candidates.front();
  const Skeleton& skeleton = database_.info().hands[database_.hand(best.row)].skeleton;
  estimate.row = best.row;
  estimate.grasp = database_.grasp(best.row);
  estimate.step = database_.step(best.row);
  estimate.camera_from_hand = best.camera_from_hand;
  estimate.angles = label_angles(database_.label(best.row));
  for (const Candidate& candidate : candidates) {
    estimate.hypotheses.push_back({candidate.row, candidate.weight});
    if (database_.grasp(candidate.row) == estimate.grasp)
      estimate.grasp_probability += candidate.weight;
  }
  const Placement placed =
      place(estimate.box, seen.camera, database_.box(best.row), database_.info().camera_distance);
  estimate.wrist =
      placed.palm_centre - best.camera_from_hand * palm_centre(skeleton, estimate.angles);
  estimate.joints =
      (best.camera_from_hand * keypoints_in_palm(skeleton, estimate.angles)).colwise() +
      estimate.wrist;
  // A box that fills the frame can put joints behind the camera: then nothing is known.
  estimate.valid = estimate.joints.row(2).minCoeff() > kNearestJoint;
  for (int i = 0; i < kKeypointCount; ++i) {
    estimate.joints_px.col(i) = seen.camera.project(estimate.joints.col(i));
  }
}

}  // namespace graspdb
