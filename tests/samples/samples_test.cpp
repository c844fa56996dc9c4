// SPDX-License-Identifier: MIT
#include "graspdb/samples/samples.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "crop_frame.h"
#include "graspdb/core/file.h"
#include "graspdb/core/hash.h"
#include "graspdb/core/json/safetensors.h"
#include "graspdb/grasps/closing.h"
#include "graspdb/grasps/grasp.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;
using testing::TemporaryDirectory;

// Small pictures of few hands, so that it is quick.
SampleConfig quick_config() {
  return {.hands = {data_directory() / "assets/hands/male.glb"},
          .views_per_pose = 4,
          .poses_per_hand = 12,
          .smallest_px = 64,
          .largest_px = 80};
}

bool same(const Sample& a, const Sample& b) {
  return a.crop.gray == b.crop.gray && a.crop.mask == b.crop.mask && a.crop.scene == b.crop.scene &&
         a.crop_from_hand == b.crop_from_hand && a.angles == b.angles && a.joints == b.joints &&
         a.hand_length == b.hand_length && a.hand == b.hand && a.grasp == b.grasp &&
         a.held == b.held;
}

std::vector<Sample> made(const SampleMaker& maker, std::uint64_t first, std::size_t count,
                         int threads = 0) {
  std::vector<Sample> samples(count);
  maker.make(first, samples, threads);
  return samples;
}

TEST(SampleMaker, ASampleDependsOnItsNumberAlone) {
  const SampleMaker maker(quick_config());
  const std::vector<Sample> all = made(maker, 10, 40);
  const std::vector<Sample> part = made(SampleMaker(quick_config()), 27, 9, 1);
  for (std::size_t i = 0; i < part.size(); ++i) EXPECT_TRUE(same(part[i], all[17 + i])) << i;
  EXPECT_FALSE(same(all[0], all[1]));
  SampleConfig other = quick_config();
  other.seed = 1;
  EXPECT_FALSE(same(made(SampleMaker(other), 10, 1)[0], all[0]));
}

TEST(SampleMaker, LabelsAreThoseOfAHandInTheCrop) {
  const SampleMaker maker(quick_config());
  for (const Sample& sample : made(maker, 0, 96)) {
    EXPECT_NEAR(sample.crop_from_hand.determinant(), 1, 1e-9);
    EXPECT_LE(range_excess(sample.angles), 1e-9);
    EXPECT_LT(palm_center(sample.joints).norm(), 1e-9);
    // From the wrist to the middle finger's tip no more than the straight hand's length.
    EXPECT_LE((sample.joints.col(12) - sample.joints.col(0)).norm(), sample.hand_length + 1e-9);
    EXPECT_GE(std::ranges::count_if(sample.crop.mask, [](auto share) { return share > 127; }), 150);
  }
}

// A true mask shows the hand where its joints are: along the crop's x and y axis the mask's mean
// and the joints' go the same way.
TEST(SampleMaker, JointsLieWhereTheMaskIs) {
  SampleConfig config = quick_config();
  config.true_masks = 1;
  config.occluders = config.held = 0;
  config.forearm_mm = 0;
  int inside = 0, all = 0;
  for (const Sample& sample : made(SampleMaker(config), 0, 64)) {
    // The longer side of the joints' box is that of the mask, fingers' flesh aside: the crop's
    // middle 50 of 64 pixels or so.
    const Eigen::Vector2d low = sample.joints.topRows<2>().rowwise().minCoeff();
    const Eigen::Vector2d high = sample.joints.topRows<2>().rowwise().maxCoeff();
    const double scale = 50 / (high - low).maxCoeff();
    for (int joint = 0; joint < kKeypointCount; ++joint) {
      const Eigen::Vector2d at = (sample.joints.col(joint).head<2>() - (low + high) / 2) * scale;
      const int x = std::clamp(static_cast<int>(32 + at.x()), 0, kCropSide - 1);
      const int y = std::clamp(static_cast<int>(32 + at.y()), 0, kCropSide - 1);
      inside +=
          sample.crop.mask[static_cast<std::size_t>(y) * kCropSide + static_cast<std::size_t>(x)] >
          127;
      ++all;
    }
  }
  EXPECT_GT(inside, 0.8 * all);
}

TEST(SampleMaker, GraspsThatAreLeftOutAreNeverDrawn) {
  SampleConfig config = quick_config();
  config.held = 1;
  config.made_hands = 0;
  for (int grasp = 3; grasp <= 33; ++grasp) config.leave_out.push_back(grasp);
  std::set<int> seen;
  const SampleMaker maker(config);
  for (const Sample& sample : made(maker, 0, 80)) seen.insert(sample.grasp);
  EXPECT_EQ(seen, (std::set{1, 2}));
  EXPECT_EQ(maker.assets().size(), 1u + 2u);  // hands, grasps
}

// Of all files that evaluation sequences are made of, and of their grasps with their objects.
std::set<std::string> sequence_hashes() {
  std::set<std::string> hashes;
  for (const auto& entry : fs::recursive_directory_iterator(data_directory() / "sequences")) {
    if (!entry.is_regular_file()) continue;
    hashes.insert(hash_hex(read_text(entry.path())));
    if (entry.path().string().ends_with(".grasp.toml")) {
      hashes.insert(grasp_hash(load_grasp(entry.path())));
    }
  }
  return hashes;
}

// All weights that come with the project.
TEST(Weights, HaveSeenNothingOfTheSequences) {
  const std::set<std::string> sequences = sequence_hashes();
  ASSERT_GT(sequences.size(), 80u);
  int files = 0;
  for (const auto& entry : fs::directory_iterator(data_directory() / "assets/descriptors")) {
    const Safetensors weights = Safetensors::load(entry.path(), std::size_t{1} << 20);
    EXPECT_EQ(weights.metadata("licence"), "MIT");
    const auto assets = nlohmann::json::parse(weights.metadata("assets"));
    EXPECT_GE(assets.size(), 4u + 33u) << entry.path();
    for (const auto& asset : assets) {
      EXPECT_FALSE(sequences.contains(asset.at("hash").get<std::string>())) << asset;
    }
    ++files;
  }
  EXPECT_GT(files, 0);
}

TEST(SampleMaker, KnowsNothingOfTheSequences) {
  const std::set<std::string> sequences = sequence_hashes();
  ASSERT_GT(sequences.size(), 80u);
  const SampleMaker maker({});
  EXPECT_EQ(maker.assets().size(), 4u + 33u);
  for (const SampleAsset& asset : maker.assets()) {
    EXPECT_FALSE(sequences.contains(asset.hash)) << asset.name;
  }
}

TEST(SampleMaker, ItsFileHoldsWhatWasDrawn) {
  const TemporaryDirectory directory;
  const SampleMaker maker(quick_config());
  const std::vector<Sample> samples = made(maker, 5, 7);
  write_samples(directory / "s.safetensors", samples, quick_config(), 5, maker.assets());
  const Safetensors file = Safetensors::load(directory / "s.safetensors", 1 << 20);
  EXPECT_EQ(file.metadata("first"), "5");
  EXPECT_EQ(file.metadata("config"), sample_config_json(quick_config()));
  const auto mask = file.tensor<std::uint8_t>({"mask", "U8", {7, 64, 64}});
  EXPECT_TRUE(std::equal(samples[2].crop.mask.begin(), samples[2].crop.mask.end(),
                         mask.begin() + 2 * static_cast<std::ptrdiff_t>(kCropPixels)));
  const auto rotation = file.tensor<float>({"rotation", "F32", {7, 3, 3}});
  EXPECT_FLOAT_EQ(rotation[9 + 1], static_cast<float>(samples[1].crop_from_hand(0, 1)));
  const auto joints = file.tensor<float>({"joints", "F32", {7, 21, 3}});
  EXPECT_FLOAT_EQ(joints[63 + 3 + 2], static_cast<float>(samples[1].joints(2, 1)));
}

TEST(DescribeSamples, AHogIsThatOfTheCrop) {
  const TemporaryDirectory directory;
  const SampleMaker maker(quick_config());
  std::vector<Sample> samples = made(maker, 5, 3);
  describe_samples(HogMode::kPaper, samples);
  GrayImage gray(kCropSide, kCropSide);
  Mask mask(kCropSide, kCropSide);
  for (std::size_t i = 0; i < kCropPixels; ++i) {
    gray.data()[i] = samples[1].crop.gray[i];
    mask.data()[i] = samples[1].crop.mask[i] >= 128 ? 255 : 0;
  }
  EXPECT_EQ(*samples[1].hog, describe(gray, mask, HogMode::kPaper));
  write_samples(directory / "s.safetensors", samples, quick_config(), 5, maker.assets());
  const Safetensors file = Safetensors::load(directory / "s.safetensors", 1 << 20);
  const auto hog = file.tensor<std::uint8_t>({"hog", "U8", {3, 512}});
  EXPECT_TRUE(std::equal(samples[2].hog->begin(), samples[2].hog->end(), hog.begin() + 1024));
}

TEST(CropFromCamera, TurnsTheRayThroughTheMiddleToTheAxis) {
  const Intrinsics camera{640, 480, 500, 510, 319.5, 239.5};
  const CropSquare square{2 * 400, 2 * 30, 90};
  const Eigen::Vector2d middle = square.middle();
  const Eigen::Vector3d turned =
      crop_from_camera(camera, square) * camera.ray(middle.x(), middle.y()).normalized();
  EXPECT_LT((turned - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
}

TEST(SequenceSamples, AreTheFramesOfTheFolder) {
  const TemporaryDirectory directory;
  const fs::path train = data_directory() / "sequences/train";
  for (const char* name : {"coin.seq.toml", "coin.grasp.toml", "rest.toml"}) {
    fs::copy_file(train / name, directory / name);
  }
  fs::create_directory(directory / "closed");
  for (const auto& entry : fs::directory_iterator(train / "closed")) {
    fs::copy_file(entry.path(), directory / "closed" / entry.path().filename());
  }
  const SequenceSamples sequences =
      sequence_samples(fs::path(directory / "coin.seq.toml").parent_path());
  EXPECT_EQ(sequences.names, std::vector<std::string>{"coin"});
  EXPECT_GT(sequences.samples.size(), 50u);
  for (const Sample& sample : sequences.samples) EXPECT_EQ(sample.sequence, 0u);
}

}  // namespace
}  // namespace graspdb
