// SPDX-License-Identifier: MIT
// An estimate is drawn with the hand that its database was built from, whatever that hand is
// called.
#include "graspdb/pictures/estimate_picture.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "graspdb/bench/held_out_queries.h"
#include "graspdb/core/error.h"
#include "graspdb/generator/generator.h"
#include "graspdb/hand/label.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr int kSide = 96;

// The child's hand under the name of a hand of ours.
class OwnHand : public ::testing::Test {
 protected:
  OwnHand() {
    const fs::path hands = GRASPDB_SOURCE_DIR "/assets/hands";
    for (const char* ending : {".glb", ".rig.toml"})
      fs::copy_file(hands / (std::string("child") + ending),
                    directory_ / (std::string("male") + ending));
  }

  Database build(const fs::path& hand, const std::string& name) {
    BuildConfig config;
    config.hands = {hand};
    config.grasps = GRASPDB_SOURCE_DIR "/grasps";
    config.only = {9};
    config.steps = 1;
    config.views = 6;
    config.resolution = 48;
    build_database(config, {.out = directory_ / name});
    return Database::open(directory_ / name);
  }

  static Estimate estimate_of(const Database& database, std::uint32_t row) {
    Estimate estimate;
    estimate.valid = true;
    estimate.row = row;
    estimate.camera_from_hand.rotation = unpack_label(database.label(row)).rotation;
    return estimate;
  }

  static ColorImage drawn(const Database& database) {
    return EstimatePicture(database).draw(estimate_of(database, 2), kSide);
  }

  testing::TemporaryDirectory directory_;
};

TEST_F(OwnHand, IsDrawnAndNotTheHandOfOursThatHasItsName) {
  const ColorImage ours = drawn(build(GRASPDB_SOURCE_DIR "/assets/hands/male.glb", "ours.graspdb"));
  const ColorImage own = drawn(build(directory_ / "male.glb", "own.graspdb"));
  const ColorImage child =
      drawn(build(GRASPDB_SOURCE_DIR "/assets/hands/child.glb", "child.graspdb"));
  EXPECT_EQ(own, child);
  EXPECT_NE(own, ours);
  const auto lit = std::ranges::count_if(own, [](const Bgr& pixel) { return pixel[2] > 60; });
  EXPECT_GT(lit, kSide * kSide / 10);
}

TEST_F(OwnHand, OfALeftHandThePictureIsTheMirroredOneOfTheMirroredAnswer) {
  const Database database = build(directory_ / "male.glb", "own.graspdb");
  Estimate mirrored_answer = estimate_of(database, 2);
  mirrored_answer.left_hand = true;
  Eigen::Matrix3d& rotation = mirrored_answer.camera_from_hand.rotation;
  const Eigen::DiagonalMatrix<double, 3> mirror(-1, 1, 1);
  rotation = mirror * rotation * mirror;
  EXPECT_EQ(EstimatePicture(database).draw(mirrored_answer, kSide), mirrored(drawn(database)));
}

TEST_F(OwnHand, AFileThatHasChangedSinceIsRefusedByName) {
  const Database database = build(directory_ / "male.glb", "own.graspdb");
  fs::copy_file(GRASPDB_SOURCE_DIR "/assets/hands/female.glb", directory_ / "male.glb",
                fs::copy_options::overwrite_existing);
  try {
    drawn(database);
    ADD_FAILURE() << "drawn";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("male.glb"));
  }
}

TEST_F(OwnHand, QueriesBetweenTheStepsAreOfThisHand) {
  const Database own = build(directory_ / "male.glb", "own.graspdb");
  const Database child = build(GRASPDB_SOURCE_DIR "/assets/hands/child.glb", "child.graspdb");
  EXPECT_EQ(held_out_queries(own, 4), held_out_queries(child, 4));
}

}  // namespace
}  // namespace graspdb
