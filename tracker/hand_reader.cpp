// SPDX-License-Identifier: MIT
#include "graspdb/tracker/hand_reader.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "graspdb/core/error.h"
#include "graspdb/core/stopwatch.h"
#include "handedness.h"
#include "mirror.h"

namespace graspdb {
namespace {

void add_times(const StageTimes& more, StageTimes& ms) {
  ms.describe += more.describe;
  ms.search += more.search;
  ms.temporal += more.temporal;
}

TrackerOptions tracker_options(const Database& database, const ReaderOptions& options) {
  return options.tracker.value_or(tuned_options(TemporalModel::kKde, descriptor_kind(database)));
}

// Of codes: most that are nearer to a row show a hand and no more. On photoreal training frames 0.3
// does as well, and 0 no better.
constexpr double kVeryNear = 0.25;

// The distance of the nearest row.
double distance_to(const Search& search, const DescriptorBytes& descriptor) {
  const std::vector<Neighbor> nearest = search.nearest(descriptor, 1);
  return nearest.empty() ? std::numeric_limits<double>::infinity()
                         : descriptor_distance(nearest.front());
}

FinderOptions finder_options(const Database& database, const Search& search,
                             const ReaderOptions& options,
                             std::shared_ptr<const Describer> describer) {
  FinderOptions finder = options.finder;
  if (finder.unlikeness) return finder;
  finder.unlikeness = unlikeness_to(database, search, options.handedness, std::move(describer));
  return finder;
}

}  // namespace

HandUnlikeness unlikeness_to(const Database& database, const Search& search, Handedness handedness,
                             std::shared_ptr<const Describer> given) {
  const auto describer = given ? std::move(given) : std::make_shared<const Describer>(database);
  const double very_near = descriptor_kind(database) == DescriptorKind::kLearned ? kVeryNear : 0;
  return [&search, handedness, describer, very_near](const GrayImage& gray, const Mask& hand) {
    double distance = std::numeric_limits<double>::infinity();
    if (handedness != Handedness::kLeft)
      distance = distance_to(search, describer->describe(gray, hand));
    if (handedness != Handedness::kRight && distance >= very_near) {
      const auto as_right = describer->describe(mirrored(gray), mirrored(hand));
      distance = std::min(distance, distance_to(search, as_right));
    }
    return distance < very_near ? 0 : distance;
  };
}

HandReader::HandReader(const Database& database, const ReaderOptions& options,
                       std::shared_ptr<const Search> search,
                       std::shared_ptr<const Describer> describer)
    : options_(options),
      search_(std::move(search)),
      right_(database, *search_, tracker_options(database, options), describer),
      left_(right_.beginning()),
      follower_(finder_options(database, *search_, options, std::move(describer)), options.roi),
      evidence_(std::make_unique<HandednessEvidence>(options.still)) {}

HandReader::HandReader(const Database& database, const ReaderOptions& options,
                       const std::string& search)
    : HandReader(database, options, open_search(database, search),
                 std::make_shared<Describer>(database)) {}

// The search is not its own: nothing is deleted.
HandReader::HandReader(const Database& database, const Search& search, const ReaderOptions& options,
                       std::shared_ptr<const Describer> describer)
    : HandReader(database, options, std::shared_ptr<const Search>(std::shared_ptr<void>(), &search),
                 describer ? std::move(describer) : std::make_shared<Describer>(database)) {}

HandReader::~HandReader() = default;
HandReader::HandReader(HandReader&&) noexcept = default;

Estimate HandReader::read(const ColorImage& frame, const Intrinsics& camera) {
  if (options_.still) forget();
  return read(observe(frame, camera));
}

Estimate HandReader::read(const ColorImage& frame, const Mask& mask, const Intrinsics& camera) {
  if (options_.still) forget();
  const Stopwatch watch;
  Observation seen = observe(to_gray(frame), mask, camera);
  seen.segment_ms = watch.ms();
  return read(std::move(seen));
}

Observation HandReader::observe(const ColorImage& frame, const Intrinsics& camera) {
  const Stopwatch watch;
  FoundHand found = follower_.next(frame);
  const bool colorless = is_empty(found.hand) && !options_.finder.net && !has_color(frame);
  const auto towards_arm = arm_direction(found);
  return {to_gray(frame), std::move(found.hand), camera, watch.ms(), colorless, towards_arm};
}

Observation HandReader::observe(GrayImage gray, const Mask& mask, const Intrinsics& camera) const {
  GRASPDB_CHECK(mask.width() == gray.width() && mask.height() == gray.height());
  const Stopwatch watch;
  FoundHand found = split_hand(mask, options_.roi);
  const auto towards_arm = arm_direction(found);
  return {std::move(gray), std::move(found.hand), camera, watch.ms(), false, towards_arm};
}

void HandReader::forget() {
  follower_.forget();
  right_.forget();
  left_.forget();
  *evidence_ = HandednessEvidence(options_.still);
}

Estimate HandReader::read_as(bool left, const Observation& seen) {
  Estimate estimate =
      left ? mirrored(left_.step(mirrored(seen)), seen.gray.width()) : right_.step(seen);
  estimate.left_hand = left;
  return estimate;
}

Estimate HandReader::read_as_either(const Observation& seen) {
  if (is_empty(seen.hand)) *evidence_ = HandednessEvidence(options_.still);  // another may come
  if (evidence_->firm()) return read_as(evidence_->left(), seen);
  Estimate right = read_as(false, seen), left = read_as(true, seen);
  if (right.no_answer != NoAnswer::kNoHand && left.no_answer != NoAnswer::kNoHand)
    evidence_->add(right.distance, left.distance);
  Estimate& answer = evidence_->left() ? left : right;
  add_times(evidence_->left() ? right.ms : left.ms, answer.ms);
  return std::move(answer);
}

Estimate HandReader::read(Observation seen) {
  const Stopwatch watch;
  Estimate estimate = options_.handedness == Handedness::kAuto
                          ? read_as_either(seen)
                          : read_as(options_.handedness == Handedness::kLeft, seen);
  estimate.ms.segment = seen.segment_ms;
  estimate.ms.total = seen.segment_ms + watch.ms();
  estimate.hand = std::move(seen.hand);
  estimate.towards_arm = seen.towards_arm;
  estimate.colorless = seen.colorless;
  return estimate;
}

}  // namespace graspdb
