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
#include "successors.h"

namespace graspdb {
namespace {

// A box twice as wide for its height as the row's shows no hand in the row's pose.
const double kLargestStretch = std::log(2.0);

double descriptor_distance(const Neighbor& neighbor) {
  return std::sqrt(static_cast<double>(neighbor.squared_distance)) / 255;
}

// How often answers of the training sequences (alpha 0 and 2 %) are right to 30 degrees, by the
// distance of the nearest descriptor: scripts/fit_confidence.py drew the curve through them.
double confidence_at(double distance, DescriptorKind kind) {
  struct Curve {
    double half, width;
  };
  const Curve curve = kind == DescriptorKind::kHog ? Curve{3.9, 1.2} : Curve{0.46, 0.07};
  return 1 / (1 + std::exp((distance - curve.half) / curve.width));
}

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
    successors_ = std::make_unique<Successors>(database);
}

Tracker::~Tracker() = default;
Tracker::Tracker(Tracker&&) noexcept = default;

Estimate Tracker::step(const Observation& seen) {
  Estimate estimate;
  if (!read(seen, estimate)) previous_.clear();
  return estimate;
}

// False, with `estimate` as far as it is known, when there is no hand.
bool Tracker::read(const Observation& seen, Estimate& estimate) {
  Stopwatch watch;
  const std::optional<Box> box = tight_box(seen.hand);
  if (!box) return false;
  estimate.box = *box;
  estimate.descriptor = describer_->describe(seen.gray, seen.hand);
  estimate.ms.describe = watch.lap_ms();
  const std::vector<Neighbor> neighbors = neighbors_of(estimate.descriptor);
  estimate.ms.search = watch.lap_ms();
  if (neighbors.empty()) return false;
  estimate.distance = descriptor_distance(neighbors.front());
  estimate.confidence = confidence_at(estimate.distance, descriptor_kind(database_));
  if (estimate.distance > options_.max_distance) return false;
  std::vector<Candidate> candidates = look_up(neighbors, *box, seen.camera);
  if (candidates.empty()) return false;
  weigh(candidates);
  const Candidate best = merged(candidates, estimate.descriptor);
  answer(candidates, best, seen.camera, estimate);
  remember(std::move(candidates), best);
  estimate.ms.temporal = watch.lap_ms();
  return true;
}

// The nearest rows, and what the last hypotheses may have become; nearest first, ties by row.
std::vector<Neighbor> Tracker::neighbors_of(DescriptorView query) const {
  std::vector<Neighbor> found = search_.nearest(query, options_.neighbors);
  if (!successors_ || previous_.empty()) return found;
  std::vector<std::uint32_t> rows;
  for (const Candidate& before : previous_) successors_->append(before.row, rows);
  for (const Neighbor& neighbor : found) rows.push_back(neighbor.row);
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
std::vector<Tracker::Candidate> Tracker::look_up(const std::vector<Neighbor>& neighbors,
                                                 const Box& box, const Intrinsics& camera) const {
  fetch_labels(database_, neighbors);
  std::vector<Candidate> candidates;
  candidates.reserve(neighbors.size());
  const double nearest = neighbors.front().squared_distance;
  for (const Neighbor& neighbor : neighbors) {
    check_row(neighbor.row);
    const BoxTangents row_box = database_.box(neighbor.row);
    // A row whose hand is wholly hidden answers nothing.
    if (!(row_box.width > 0 && row_box.height > 0)) continue;
    const double stretch = log_stretch(box, camera, row_box);
    if (std::abs(stretch) > kLargestStretch) continue;
    const LabelPose row = unpack_label(database_.label(neighbor.row));
    Candidate candidate{.row = neighbor.row, .angles = row.angles};
    candidate.placement = place(box, camera, row_box, database_.info().camera_distance);
    candidate.rotation = candidate.placement.camera_from_row_camera * row.rotation;
    candidate.pose = pose_vector(candidate.rotation, row.angles);
    const double further = (neighbor.squared_distance - nearest) / (255.0 * 255.0);
    candidate.log_weight =
        -further / (2 * options_.sigma_hog * options_.sigma_hog) -
        stretch * stretch / (2 * options_.sigma_stretch * options_.sigma_stretch);
    candidates.push_back(std::move(candidate));
  }
  return candidates;
}

void Tracker::answer(const std::vector<Candidate>& candidates, const Candidate& best,
                     const Intrinsics& camera, Estimate& estimate) const {
  const Skeleton& skeleton = database_.info().hands[database_.hand(best.row)].skeleton;
  estimate.row = best.row;
  estimate.grasp = database_.grasp(best.row);
  estimate.step = database_.step(best.row);
  estimate.angles = best.angles;
  estimate.hypotheses.reserve(candidates.size());
  for (const Candidate& candidate : candidates) {
    estimate.hypotheses.push_back({candidate.row, candidate.weight});
    if (database_.grasp(candidate.row) == estimate.grasp)
      estimate.grasp_probability += candidate.weight;
  }
  const Eigen::Vector3d wrist =
      best.placement.palm_center - best.rotation * palm_center(skeleton, best.angles);
  estimate.camera_from_hand = {best.rotation, wrist};
  estimate.joints = (best.rotation * keypoints_in_hand(skeleton, best.angles)).colwise() + wrist;
  // A box that fills the frame can put joints behind the camera: then nothing is known.
  estimate.valid = estimate.joints.row(2).minCoeff() > kNearestDepth;
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
