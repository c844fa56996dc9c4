// SPDX-License-Identifier: MIT
#include "graspdb/tracker/hand_reader.h"

#include <utility>

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

}  // namespace

HandReader::HandReader(const Database& database, const ReaderOptions& options,
                       const std::string& search)
    : options_(options),
      follower_(options.finder, options.roi),
      own_search_(open_search(database, search)),
      search_(*own_search_),
      right_(database, search_, tracker_options(database, options)),
      left_(right_.beginning()),
      evidence_(std::make_unique<HandednessEvidence>(options.still)) {}

HandReader::HandReader(const Database& database, const Search& search, const ReaderOptions& options,
                       std::shared_ptr<const Describer> describer)
    : options_(options),
      follower_(options.finder, options.roi),
      search_(search),
      right_(database, search_, tracker_options(database, options), std::move(describer)),
      left_(right_.beginning()),
      evidence_(std::make_unique<HandednessEvidence>(options.still)) {}

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
  return read(seen);
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

Estimate HandReader::read(const Observation& seen) {
  const Stopwatch watch;
  Estimate estimate = options_.handedness == Handedness::kAuto
                          ? read_as_either(seen)
                          : read_as(options_.handedness == Handedness::kLeft, seen);
  estimate.ms.segment = seen.segment_ms;
  estimate.ms.total = seen.segment_ms + watch.ms();
  estimate.hand = seen.hand;
  estimate.towards_arm = seen.towards_arm;
  estimate.colorless = seen.colorless;
  return estimate;
}

}  // namespace graspdb
