// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <mutex>

#include "graspdb/core/error.h"
#include "graspdb/core/parallel.h"
#include "graspdb/core/transform.h"
#include "graspdb/samples/samples.h"
#include "sample_hands.h"
#include "sample_picture.h"
#include "sample_poses.h"

namespace graspdb {
namespace {

// A number is asked for until a picture shows enough; a hand is nearly always seen at once.
constexpr int kMostPictures = 50;
// A third of those of rows: they take most of the time, and no one will look at these creases.
constexpr int kFewOpennessRays = 8;

// Streams of one seed: hands, poses and pictures have numbers of their own.
enum Purpose : std::uint64_t { kHandDraws, kPoseDraws, kPictureDraws, kPurposes };

RandomStream stream(const SampleConfig& config, Purpose purpose, std::uint64_t number) {
  return RandomStream(static_cast<std::uint64_t>(config.seed), number * kPurposes + purpose);
}

// The hands that are being shown, each made once.
class SampleHands {
 public:
  SampleHands(const HandLibrary& library, const SampleConfig& config)
      : library_(library), config_(config) {}

  const SampleHand& of(std::uint64_t number) {
    Entry& entry = entry_of(number);
    std::call_once(entry.drawn, [&] {
      entry.hand = draw_hand(library_, config_, stream(config_, kHandDraws, number));
    });
    return entry.hand;
  }

 private:
  struct Entry {
    std::once_flag drawn;
    SampleHand hand;
  };
  Entry& entry_of(std::uint64_t number) {
    const std::lock_guard lock(mutex_);
    return entries_[number];
  }

  const HandLibrary& library_;
  const SampleConfig& config_;
  std::mutex mutex_;
  std::map<std::uint64_t, Entry> entries_;
};

struct PosedSample {
  SampleScene scene;
  Sample label;      // what all views share
  Keypoints joints;  // hand frame, from the palm centre
};

PosedSample pose_sample(const HandLibrary& library, const SampleHand& hand,
                        const SampleConfig& config, RandomStream random) {
  const SamplePose drawn = draw_pose(library, hand, config, random);
  const Skeleton& skeleton = hand.hand.skeleton;
  PosedSample posed{
      .scene = {pose_scene(with_visible_forearm(hand.hand, drawn.visible_forearm), drawn.pose,
                           drawn.object.get(), kFewOpennessRays),
                -hand_from_bones(skeleton, drawn.pose.angles)[kForearm].rotation.col(1)},
      .label = {.angles = drawn.pose.angles,
                .hand_length = hand_length(skeleton),
                .grasp = drawn.grasp,
                .held = drawn.object != nullptr},
      .joints = keypoints_in_hand(skeleton, drawn.pose.angles)};
  posed.joints.colwise() -= posed.scene.posed.center;
  return posed;
}

Sample draw_sample(const PosedSample& posed, const SampleConfig& config, RandomStream random) {
  for (int draw = 0; draw < kMostPictures; ++draw) {
    std::optional<Sample> picture = draw_picture(posed.scene, config, random);
    if (!picture) continue;
    Sample sample = posed.label;
    sample.crop = picture->crop;
    sample.crop_from_hand = picture->crop_from_hand;
    sample.joints = sample.crop_from_hand * posed.joints;
    return sample;
  }
  throw Error("samples: a hand that no camera sees");
}

Descriptor hog_of(const HandCrop& crop, HogMode mode) {
  GrayImage gray(kCropSide, kCropSide);
  Mask mask(kCropSide, kCropSide);
  std::ranges::copy(crop.gray, gray.begin());
  std::ranges::transform(crop.mask, mask.begin(),
                         [](std::uint8_t share) { return share > 127 ? 255 : 0; });
  return describe(gray, mask, mode);
}

}  // namespace

struct SampleMaker::State {
  SampleConfig config;
  HandLibrary library;
};

SampleMaker::SampleMaker(const SampleConfig& config, int threads)
    : state_(new State{config, load_hand_library(config, threads)}) {}
SampleMaker::~SampleMaker() = default;

const std::vector<SampleAsset>& SampleMaker::assets() const {
  return state_->library.assets;
}

void SampleMaker::make(std::uint64_t first, std::span<Sample> samples, int threads,
                       const Progress& progress) const {
  if (samples.empty()) return;
  const auto& [config, library] = *state_;
  const auto views = static_cast<std::uint64_t>(config.views_per_pose);
  const std::uint64_t end = first + samples.size();
  const std::uint64_t first_pose = first / views, poses = (end - 1) / views + 1 - first_pose;
  SampleHands hands(library, config);
  std::mutex mutex;
  std::size_t done = 0;
  parallel_for(poses, threads, [&](std::size_t i) {
    const std::uint64_t pose = first_pose + i;
    const std::uint64_t hand = pose / static_cast<std::uint64_t>(config.poses_per_hand);
    const PosedSample posed =
        pose_sample(library, hands.of(hand), config, stream(config, kPoseDraws, pose));
    const std::uint64_t begin = std::max(first, pose * views);
    const std::uint64_t stop = std::min(end, (pose + 1) * views);
    for (std::uint64_t n = begin; n < stop; ++n) {
      Sample& sample = samples[n - first];
      sample = draw_sample(posed, config, stream(config, kPictureDraws, n));
      sample.hand = hand;
    }
    const std::lock_guard lock(mutex);
    done += stop - begin;
    if (progress) progress(done, samples.size());
  });
}

void describe_samples(const EmbeddingNet& net, std::span<Sample> samples, int threads) {
  parallel_for(samples.size(), threads,
               [&](std::size_t i) { samples[i].embedding = net.describe(samples[i].crop); });
}

void describe_samples(HogMode mode, std::span<Sample> samples, int threads) {
  parallel_for(samples.size(), threads,
               [&](std::size_t i) { samples[i].hog = hog_of(samples[i].crop, mode); });
}

}  // namespace graspdb
