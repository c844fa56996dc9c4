// SPDX-License-Identifier: MIT
// Varied rows: what an amplitude changes, what a draw depends on, and what it does not.
#include <gmock/gmock.h>

#include <set>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/transform.h"
#include "graspdb/database/database.h"
#include "graspdb/generator/generator.h"
#include "graspdb/hand/angles.h"
#include "small_build.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class Jittered : public ::testing::Test {
 protected:
  Database build(const BuildConfig& config, BuildJob job = {}) {
    job.out = directory_ / std::to_string(++builds_);
    rendered_rows_ = build_database(config, job).rendered_rows;
    return Database::open(job.out);
  }
  // The small build with this jitter.
  Database with(const Jitter& jitter) {
    BuildConfig config = testing::small_config();
    config.jitter = jitter;
    return build(config);
  }

  testing::TemporaryDirectory directory_;
  int builds_ = 0;
  std::size_t rendered_rows_ = 0;
};

const Jitter kAllButSize{
    .angles_deg = 6, .wrist_deg = 8, .visible_forearm_mm = 30, .light_deg = 40, .seed = 5};

std::vector<float> label_of(const Database& database, std::size_t row) {
  const auto label = database.label(row);
  return {label.begin(), label.end()};
}

double mean_hog_difference(const Database& a, const Database& b) {
  double sum = 0;
  const DescriptorView of_a = a.hogs().bytes, of_b = b.hogs().bytes;
  for (std::size_t i = 0; i < of_a.size(); ++i) sum += std::abs(of_a[i] - of_b[i]);
  return sum / static_cast<double>(of_a.size());
}

// The largest difference between the two's angles first..last, degrees.
double largest_deg(const Database& a, const Database& b, int first, int last) {
  double largest = 0;
  for (std::size_t row = 0; row < a.rows(); ++row) {
    for (int i = first; i <= last; ++i) {
      const auto index = static_cast<std::size_t>(i + 3);
      largest = std::max(largest, std::abs(degrees(a.label(row)[index] - b.label(row)[index])));
    }
  }
  return largest;
}

bool same_rows(const Database& a, std::size_t from_a, const Database& b, std::size_t from_b,
               std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (label_of(a, from_a + i) != label_of(b, from_b + i)) return false;
    if (!std::ranges::equal(a.hog(from_a + i), b.hog(from_b + i))) return false;
  }
  return true;
}

TEST_F(Jittered, AnglesChangeTheDigitsWithinTheAmplitudeAndTheirRanges) {
  const Database plain = with({}), varied = with({.angles_deg = 6});
  EXPECT_EQ(largest_deg(plain, varied, kWristFlexion, kWristDeviation), 0);
  EXPECT_GT(largest_deg(plain, varied, kThumbCmcFlexion, kAngleCount - 1), 4);
  EXPECT_LE(largest_deg(plain, varied, kThumbCmcFlexion, kAngleCount - 1), 6.001);
  for (std::size_t row = 0; row < varied.rows(); ++row) {
    const auto label = varied.label(row);
    JointAngles angles;
    for (int i = 0; i < kAngleCount; ++i) angles[i] = label[static_cast<std::size_t>(i + 3)];
    EXPECT_LT(range_excess(angles), 1e-6);
  }
}

TEST_F(Jittered, WristChangesTheWristAlone) {
  const Database plain = with({}), varied = with({.wrist_deg = 8});
  EXPECT_GT(largest_deg(plain, varied, kWristFlexion, kWristFlexion), 0.1);
  EXPECT_GT(largest_deg(plain, varied, kWristDeviation, kWristDeviation), 0.1);
  EXPECT_LE(largest_deg(plain, varied, kWristFlexion, kWristDeviation), 8.001);
  EXPECT_EQ(largest_deg(plain, varied, kThumbCmcFlexion, kAngleCount - 1), 0);
}

TEST_F(Jittered, ForearmAndLightChangeThePictureAndNoLabel) {
  const Database plain = with({});
  for (const Jitter& jitter : {Jitter{.visible_forearm_mm = 60}, Jitter{.light_deg = 60}}) {
    const Database varied = with(jitter);
    EXPECT_EQ(largest_deg(plain, varied, 0, kAngleCount - 1), 0);
    EXPECT_GT(mean_hog_difference(plain, varied), 1);
  }
}

TEST_F(Jittered, LightLeavesTheBoxAndTheForearmDoesNot) {
  const auto widest = [](const Database& a, const Database& b) {
    float largest = 0;
    for (std::size_t row = 0; row < a.rows(); ++row)
      largest = std::max(largest, std::abs(a.box(row).width - b.box(row).width));
    return largest;
  };
  const Database plain = with({});
  EXPECT_EQ(widest(plain, with({.light_deg = 60})), 0);
  EXPECT_GT(widest(plain, with({.visible_forearm_mm = 60})), 0.01F);
}

TEST_F(Jittered, HeldAndFreeRowsOfACopyAreOnePose) {
  const Database varied = with(kAllButSize);
  for (std::size_t row = 0; row < 48; ++row)
    EXPECT_EQ(label_of(varied, row), label_of(varied, row + 48));
}

TEST_F(Jittered, CopiesAreDrawnDifferentlyAndMoreOfThemLeaveTheFirst) {
  Jitter jitter = kAllButSize;
  const Database one = with(jitter);
  jitter.copies = 3;
  const Database three = with(jitter);
  EXPECT_THAT(three.info().variants,
              ElementsAre("held", "free", "held 2", "free 2", "held 3", "free 3"));
  ASSERT_EQ(three.rows(), 3 * one.rows());
  EXPECT_TRUE(same_rows(one, 0, three, 0, one.rows()));
  std::set<std::vector<float>> poses;
  for (std::size_t row = 0; row < three.rows(); ++row) {
    EXPECT_EQ(three.variant(row), row / 48);
    if (row % 12 == 0) poses.insert(label_of(three, row));
  }
  EXPECT_EQ(poses.size(), 3u * 2 * 2);  // copies, grasps, steps
}

TEST_F(Jittered, ARowDoesNotDependOnTheOtherGraspsOrHands) {
  BuildConfig config = testing::small_config();
  config.jitter = kAllButSize;
  const Database two = build(config);
  config.only = {9};
  EXPECT_TRUE(same_rows(two, 24, build(config), 0, 24));
  config.hands.insert(config.hands.begin(),
                      std::filesystem::path(GRASPDB_SOURCE_DIR) / "assets/hands/child.glb");
  EXPECT_TRUE(same_rows(two, 24, build(config), 48, 24));
}

TEST_F(Jittered, NeitherThreadsNorShardsChangeAByte) {
  BuildConfig config = testing::small_config();
  config.jitter = kAllButSize;
  config.jitter.copies = 2;
  const std::string hash = build(config, {.threads = 1}).content_hash();
  EXPECT_EQ(build(config, {.threads = 2}).content_hash(), hash);
  EXPECT_EQ(build(config, {.threads = 7}).content_hash(), hash);
  const BuildJob merged{.out = directory_ / "merged", .work = directory_ / "work"};
  for (int shard = 0; shard < 3; ++shard) {
    BuildJob part = merged;
    part.shard = shard, part.shards = 3;
    build_database(config, part);
  }
  EXPECT_EQ(merge_shards(merged).content_hash, hash);
  EXPECT_EQ(build_database(load_config(merged.out), {.out = directory_ / "again"}).content_hash,
            hash);
}

TEST_F(Jittered, AnotherSeedGivesOtherRows) {
  Jitter jitter = kAllButSize;
  const Database five = with(jitter);
  jitter.seed = 6;
  const Database six = with(jitter);
  EXPECT_GT(largest_deg(five, six, kThumbCmcFlexion, kAngleCount - 1), 4);
}

TEST_F(Jittered, EveryAmplitudeMakesShardsAgain) {
  BuildConfig config = testing::small_config();
  config.only = {3};
  const BuildJob job{.work = directory_ / "work"};
  config.jitter = kAllButSize;
  build(config, job);
  build(config, job);
  EXPECT_EQ(rendered_rows_, 0u);
  const auto rendered_with = [&](const auto& change) {
    config.jitter = kAllButSize;
    change(config.jitter);
    build(config, job);
    return rendered_rows_ == 48;
  };
  EXPECT_TRUE(rendered_with([](Jitter& j) { j.angles_deg = 7; }));
  EXPECT_TRUE(rendered_with([](Jitter& j) { j.wrist_deg = 7; }));
  EXPECT_TRUE(rendered_with([](Jitter& j) { j.visible_forearm_mm = 7; }));
  EXPECT_TRUE(rendered_with([](Jitter& j) { j.light_deg = 7; }));
  EXPECT_TRUE(rendered_with([](Jitter& j) { j.seed = 7; }));
  EXPECT_TRUE(rendered_with([](Jitter& j) { j.copies = 2; }));  // and keeps the first
}

TEST_F(Jittered, ASizedObjectIsHeldByAHandThatClosedOnIt) {
  BuildConfig config = testing::small_config();
  config.only = {3};
  config.steps = 1;
  const Database plain = build(config);
  config.jitter = {.object_size_percent = 20, .seed = 2};
  const Database sized = build(config), again = build(config, {.threads = 1});
  EXPECT_EQ(sized.content_hash(), again.content_hash());
  // It opens or closes, in held and free rows alike.
  EXPECT_GT(largest_deg(plain, sized, kThumbCmcFlexion, kAngleCount - 1), 0.5);
  EXPECT_EQ(label_of(sized, 0), label_of(sized, 12));
}

TEST_F(Jittered, WhatCannotBeDrawnIsRefused) {
  const auto refusal = [&](const Jitter& jitter) -> std::string {
    try {
      with(jitter);
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(refusal({.angles_deg = 31}), HasSubstr("jitter angles, degrees"));
  EXPECT_THAT(refusal({.wrist_deg = -1}), HasSubstr("jitter wrist, degrees"));
  EXPECT_THAT(refusal({.object_size_percent = 40}), HasSubstr("jitter object size, %"));
  EXPECT_THAT(refusal({.visible_forearm_mm = 300}), HasSubstr("jitter forearm, mm"));
  EXPECT_THAT(refusal({.light_deg = 91}), HasSubstr("jitter light, degrees"));
  EXPECT_THAT(refusal({.copies = 2}), HasSubstr("jitter copies, which differ only by jitter"));
}

TEST_F(Jittered, ATextFileMayAskForItAndAStoredOneStatesItWhole) {
  write_text(directory_ / "a.toml", "[jitter]\nwrist_deg = 3\ncopies = 2\n");
  const BuildConfig config = load_config(directory_ / "a.toml");
  EXPECT_EQ(config.jitter.wrist_deg, 3);
  EXPECT_EQ(config.jitter.copies, 2);
  EXPECT_EQ(config.jitter.angles_deg, 0);
  std::string stored = config_to_json(config);
  write_text(directory_ / "a.json", stored);
  EXPECT_EQ(config_to_json(load_config(directory_ / "a.json")), stored);
  const std::string seed = ",\"seed\":0";
  write_text(directory_ / "a.json", stored.erase(stored.find(seed), seed.size()));
  EXPECT_THROW(load_config(directory_ / "a.json"), Error);
}

TEST_F(Jittered, AConfigurationOfNamesThatNoFileCanHaveIsRefused) {
  for (const std::string key : {"grasps = \"", "hands = [\""}) {
    const std::string end = key.ends_with("[\"") ? "\"]" : "\"";
    write_text(directory_ / "a.toml", key + std::string(300, 'x') + end);
    EXPECT_THROW(load_config(directory_ / "a.toml"), Error) << key;
  }
}

TEST_F(Jittered, TwoHandsInOneBuildHaveTheirOwnRows) {
  BuildConfig config = testing::small_config();
  config.hands.push_back(std::filesystem::path(GRASPDB_SOURCE_DIR) / "assets/hands/child.glb");
  const Database both = build(config);
  ASSERT_EQ(both.rows(), 192u);
  for (std::size_t row = 0; row < both.rows(); ++row) EXPECT_EQ(both.hand(row), row / 96);
  const auto& hands = both.info().hands;
  EXPECT_EQ(hands[0].name, "male");
  EXPECT_EQ(hands[1].name, "child");
  EXPECT_NEAR(hand_length(hands[0].skeleton), 0.193, 1e-4);
  EXPECT_NEAR(hand_length(hands[1].skeleton), 0.140, 1e-4);
  // Each of them alone gives the same rows: the child closes on the same object in its own way.
  config.hands.erase(config.hands.begin());
  EXPECT_TRUE(same_rows(both, 96, build(config), 0, 96));
  EXPECT_NE(label_of(both, 12), label_of(both, 96 + 12));
}

}  // namespace
}  // namespace graspdb
