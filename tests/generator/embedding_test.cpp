// SPDX-License-Identifier: MIT
#include "graspdb/features/embedding.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "features/net_bytes.h"
#include "generator/small_build.h"
#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/generator/generator.h"
#include "graspdb/generator/row_poses.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryDirectory;

class EmbeddedBuild : public ::testing::Test {
 protected:
  EmbeddedBuild() {
    write_text(weights_, testing::small_net(3).bytes());
    config_.descriptor = weights_;
    config_.only = {9};
  }
  Database build(const char* name) {
    build_database(config_, {.out = directory_ / name});
    return Database::open(directory_ / name);
  }

  TemporaryDirectory directory_;
  std::filesystem::path weights_ = directory_ / "small.safetensors";
  BuildConfig config_ = testing::small_config();
};

TEST_F(EmbeddedBuild, RowsHaveTheCodesOfTheirPictures) {
  const Database database = build("a.graspdb");
  const EmbeddingNet net = EmbeddingNet::load(weights_);
  EXPECT_EQ(database.info().descriptor, "small");
  EXPECT_EQ(database.info().weights, net.hash());
  const RowPoses poses(config_);
  const PoseKey key{.variant = database.variant(7), .grasp = 9, .step = database.step(7)};
  const RowPose pose = poses.pose(key);
  const View view = row_view(pose.scene.scene, poses.camera(pose, database.view(7)),
                             poses.light(key, database.view(7)), config_.renderer);
  const Mask hand = visible_hand(view);
  const Embedding expected = net.describe(crop_hand(view.shading, hand, *crop_square(hand)));
  EXPECT_TRUE(std::ranges::equal(database.descriptors().row(7), expected));
}

TEST_F(EmbeddedBuild, TheDatabaseIsMadeAgainFromItsConfigurationAndOtherWeightsAreRefused) {
  const std::string hash = build("a.graspdb").content_hash();
  config_ = load_config(directory_ / "a.graspdb");
  EXPECT_EQ(build("b.graspdb").content_hash(), hash);
  write_text(weights_, testing::small_net(4).bytes());
  try {
    build("c.graspdb");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("small.safetensors"));
  }
  config_.descriptor_hash.clear();
  EXPECT_NE(build("c.graspdb").content_hash(), hash);
}

}  // namespace
}  // namespace graspdb
