// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <set>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/hash.h"
#include "graspdb/database/database.h"
#include "graspdb/generator/generator.h"
#include "graspdb/generator/posed_scene.h"
#include "graspdb/generator/views.h"
#include "graspdb/grasps/closing.h"
#include "graspdb/hand/rig/rig.h"
#include "small_build.h"
#include "support/source_folder.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using ::testing::HasSubstr;

using testing::kSource;

using testing::small_config;

class Build : public ::testing::Test {
 protected:
  Database build(const BuildConfig& config, const std::string& name = "a.graspdb") {
    build_database(config, {.out = directory_ / name});
    return Database::open(directory_ / name);
  }
  testing::TemporaryDirectory directory_;
};

TEST_F(Build, RowsFollowTheFormula) {
  const Database database = build(small_config());
  ASSERT_EQ(database.rows(), 2u * 2 * 2 * 12);
  for (std::size_t row = 0; row < database.rows(); ++row) {
    EXPECT_EQ(database.view(row), row % 12);
    EXPECT_EQ(database.step(row), row / 12 % 2 + 1);
    EXPECT_EQ(database.grasp(row), row / 24 % 2 == 0 ? 3 : 9);
    EXPECT_EQ(database.variant(row), row / 48);
  }
  EXPECT_THAT(database.info().variants, ::testing::ElementsAre("held", "free"));
}

TEST_F(Build, LabelsHoldTheViewsAndTheClosedAngles) {
  const Database database = build(small_config());
  const auto views = view_rotations(12);
  const auto committed = load_closed_poses(kSource / "grasps/closed/male.toml").poses;
  for (std::size_t row = 0; row < database.rows(); ++row) {
    const auto label = database.label(row);
    EXPECT_LT(angle_between(rotation_from_vector({label[0], label[1], label[2]}), views[row % 12]),
              1e-5);
    const int id = database.grasp(row);
    if (database.step(row) == 2) {
      const JointAngles& closed = committed.at(id).angles;
      for (int i = 0; i < kAngleCount; ++i) {
        EXPECT_NEAR(label[static_cast<std::size_t>(3 + i)], closed[i], 1e-6);
      }
    }
    const auto same_pose_free = database.label(row % 48 + 48);
    EXPECT_TRUE(std::equal(label.begin(), label.end(), same_pose_free.begin()));
  }
}

TEST_F(Build, TheNumberOfThreadsChangesNoByte) {
  for (const int threads : {1, 2, 7}) {
    const std::string name = std::to_string(threads);
    build_database(small_config(), {.out = directory_ / name, .threads = threads});
  }
  EXPECT_EQ(read_text(directory_ / "1"), read_text(directory_ / "2"));
  EXPECT_EQ(read_text(directory_ / "1"), read_text(directory_ / "7"));
}

TEST_F(Build, AHeldObjectChangesWhatIsSeenAndADescriptorIsNeverEmpty) {
  const Database database = build(small_config());
  int different = 0;
  for (std::size_t row = 0; row < 48; ++row) {
    const auto held = database.hog(row), free = database.hog(row + 48);
    different += std::equal(held.begin(), held.end(), free.begin()) ? 0 : 1;
    EXPECT_GT(*std::max_element(free.begin(), free.end()), 0);
    EXPECT_GT(database.box(row + 48).width, 0.02F);  // 14 mm at 0.7 m
    EXPECT_LT(database.box(row + 48).width, 0.6F);
  }
  EXPECT_GT(different, 40);
}

TEST_F(Build, TheConfigurationNamesTheFilesThatItWasMadeFrom) {
  const std::string config = build(small_config()).info().config;
  EXPECT_THAT(config, HasSubstr(hash_hex(read_text(kSource / "assets/hands/male.glb") +
                                         read_text(kSource / "assets/hands/male.rig.toml"))));
  EXPECT_THAT(config, HasSubstr(hash_hex(read_text(kSource / "grasps/09_palmar_pinch.toml"))));
}

TEST_F(Build, ProgressEndsWithAllRows) {
  std::size_t last = 0;
  const auto progress = [&](std::size_t done, std::size_t total) {
    EXPECT_GT(done, last);
    EXPECT_EQ(total, 96u);
    last = done;
  };
  build_database(small_config(), {.out = directory_ / "p", .progress = progress});
  EXPECT_EQ(last, 96u);
}

TEST_F(Build, BadInputIsNamedAndLeavesNothing) {
  const auto message = [&](const auto& change) -> std::string {
    BuildConfig config = small_config();
    change(config);
    try {
      build(config, "bad");
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(message([](BuildConfig& c) { c.only = {77}; }), HasSubstr("grasp 77"));
  EXPECT_THAT(message([](BuildConfig& c) { c.hands = {"/nowhere.glb"}; }),
              HasSubstr("/nowhere.glb"));
  EXPECT_THAT(message([](BuildConfig& c) { c.views = 0; }), HasSubstr("views"));
  EXPECT_THAT(message([](BuildConfig& c) { c.grasps = "/nowhere"; }), HasSubstr("/nowhere"));
  EXPECT_TRUE(std::filesystem::is_empty(directory_.path()));
}

TEST(VisibleForearm, EndsWhereItIsAskedToAndKeepsItsTriangles) {
  const Hand whole = load_hand(kSource / "assets/hands/male.glb");
  const Hand cut = with_visible_forearm(whole, 0.025);
  float lowest = 0;
  for (const Eigen::Vector3f& v : cut.bind_mesh.vertices) lowest = std::min(lowest, v.y());
  EXPECT_NEAR(lowest, -0.025F, 1e-4F);
  EXPECT_EQ(cut.bind_mesh.triangles, whole.bind_mesh.triangles);
  for (std::size_t v = 0; v < cut.bind_mesh.vertices.size(); ++v) {
    if (whole.bind_mesh.vertices[v].y() < -0.03F) {
      EXPECT_LT(cut.bind_mesh.normals[v].y(), -0.99F);  // the end plane faces the elbow
    }
  }
}

}  // namespace
}  // namespace graspdb
