// SPDX-License-Identifier: MIT
#include "graspdb/pictures/database_rows.h"

#include <gmock/gmock.h>

#include <fstream>
#include <numeric>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/features/hog.h"
#include "small_database.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::vector<std::size_t> all_rows(const Database& database) {
  std::vector<std::size_t> rows(database.rows());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  return rows;
}

// All rows of the small database as views, poses made once.
std::vector<LabelledView> all_views(const Layers& layers) {
  const Database& database = testing::small_database();
  const DatabaseRows rows(database, all_rows(database));
  std::vector<LabelledView> views;
  std::optional<Subject> subject;
  for (std::size_t row = 0; row < database.rows(); ++row) {
    if (row == 0 || rows.key(row) != rows.key(row - 1)) subject.emplace(rows.subject(row));
    views.push_back(rows.view(*subject, row, layers));
  }
  return views;
}

std::size_t unlike_pixels(const GrayImage& a, const GrayImage& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a.data()[i] != b.data()[i];
  return count;
}

TEST(DatabaseRows, APictureShowsWhatTheRowWasDescribedFrom) {
  const Database& database = testing::small_database();
  const HogMode hog = hog_from_name(database.info().hog, "the database");
  const std::vector<std::size_t> every = all_rows(database);
  const DatabaseRows rows(database, every);
  std::size_t unlike = 0;
  for (const std::size_t row : every) {
    const Subject subject = rows.subject(row);
    const LabelledView shown = rows.view(subject, row, {});
    const View described =
        row_view(subject.pose().scene.scene, shown.camera, {}, RowRenderer::kRaster);
    EXPECT_TRUE(std::ranges::equal(describe(described.shading, visible_hand(described), hog),
                                   database.hog(row)))
        << row;
    unlike += unlike_pixels(shown.picture.label, described.label);
  }
  EXPECT_LE(unlike, 3);
}

TEST(DatabaseRows, OneRowNeedsItsGraspOnly) {
  const Database& database = testing::small_database();
  const std::size_t row = 40;
  const DatabaseRows one(database, std::vector{row}), all(database, all_rows(database));
  EXPECT_EQ(one.view(one.subject(row), row, {}).picture.shading,
            all.view(all.subject(row), row, {}).picture.shading);
  EXPECT_EQ(one.grasp(row).id, database.grasp(row));
}

TEST(DatabaseRows, AnotherResolutionShowsTheSame) {
  const Database& database = testing::small_database();
  const DatabaseRows small(database, std::vector<std::size_t>{7});
  const DatabaseRows large(database, std::vector<std::size_t>{7}, 144);
  const LabelledView a = small.view(small.subject(7), 7, {});
  const LabelledView b = large.view(large.subject(7), 7, {});
  EXPECT_EQ(b.picture.shading.width(), 144);
  EXPECT_LT((a.joints - b.joints).norm(), 1e-12);
  // Three of the large picture's pixels are one of the small one's; centres shift by half.
  const auto scaled = (a.joints_px.array() + 0.5) * 3 - 0.5;
  EXPECT_LT((scaled - b.joints_px.array()).abs().maxCoeff(), 1e-6);
}

TEST(DatabaseRows, HeldRowsHideWhatFreeOnesShow) {
  const std::vector<LabelledView> views = all_views(kAllLayers);
  int hidden_rows = 0;
  for (std::size_t row = 0; row < 48; ++row) {
    const LabelledView &held = views[row], &free = views[row + 48];
    EXPECT_EQ(held.picture.hand_amodal, free.picture.hand_amodal);
    EXPECT_LE(held.hand.visible, held.hand.amodal);
    EXPECT_LE(held.object.visible, held.object.amodal);
    EXPECT_EQ(free.hand.visible, free.hand.amodal);
    EXPECT_TRUE(held.camera_from_object && !free.camera_from_object);
    hidden_rows += *held.hand.occlusion() > 0.1 ? 1 : 0;
    for (std::size_t i = 0; i < kKeypointCount; ++i) {
      if (held.joint_states[i] == kVisibleInPicture) {
        EXPECT_EQ(free.joint_states[i], kVisibleInPicture) << row << ' ' << i;
      }
    }
  }
  EXPECT_GT(hidden_rows, 5);
}

// From enough sides that none weighs too much.
std::vector<LabelledView> many_views() {
  BuildConfig config = testing::small_config();
  config.views = 100;
  config.resolution = 128;
  const RowPoses poses(config);
  std::vector<LabelledView> views;
  for (const auto& [grasp, step] : {std::pair(3, 1), {3, 2}, {9, 1}, {9, 2}}) {
    const Subject subject(poses.hand(0), poses.pose({.grasp = grasp, .step = step}));
    for (std::size_t view = 0; view < 100; ++view) {
      views.push_back(subject.seen(poses.camera(subject.pose(), view), {}, {.parts = true}));
    }
  }
  return views;
}

// Would fail if ring and little finger were swapped in keypoints or parts.
TEST(DatabaseRows, AVisibleJointLiesOnSkinOfItsOwnDigit) {
  std::array<int, kKeypointCount> on_own{}, on_other{};
  for (const LabelledView& view : many_views()) {
    for (int i = 0; i < kKeypointCount; ++i) {
      const auto place = static_cast<std::size_t>(i);
      if (view.joint_states[place] != kVisibleInPicture) continue;
      const Eigen::Vector2i px = view.joints_px.col(i).array().round().cast<int>();
      const int bone = view.picture.part.at(px.x(), px.y()) - 1;
      if (bone < 0) continue;  // between a tip's point and the next pixel's centre
      ++(testing::bones_around(i).contains(bone) ? on_own : on_other)[place];
    }
  }
  for (std::size_t i = 0; i < kKeypointCount; ++i) {
    EXPECT_GT(on_own[i], 20) << keypoint_name(static_cast<int>(i));
    // At the edges of a palm a joint's own flesh may bear its neighbour's skin.
    EXPECT_LT(on_other[i], on_own[i] / 2) << keypoint_name(static_cast<int>(i));
  }
}

TEST(DatabaseRows, ChangedAndAbsentFilesAreNamed) {
  const testing::TemporaryDirectory directory;
  const fs::path source = GRASPDB_SOURCE_DIR;
  for (const char* file : {"male.glb", "male.rig.toml"}) {
    fs::copy(source / "assets/hands" / file, directory / file);
  }
  fs::create_directory(directory / "grasps");
  fs::copy(source / "grasps/09_palmar_pinch.toml", directory / "grasps");
  fs::copy(source / "grasps/rest.toml", directory / "grasps");
  fs::create_directory(directory / "grasps/closed");
  fs::copy(source / "grasps/closed/male.toml", directory / "grasps/closed");
  BuildConfig config = testing::small_config();
  config.hands = {directory / "male.glb"};
  config.grasps = directory / "grasps";
  config.only = {9};
  config.views = 2;
  build_database(config, {.out = directory / "a.graspdb"});
  const Database database = Database::open(directory / "a.graspdb");
  const std::vector<std::size_t> row = {1};
  const auto refusal = [&]() -> std::string {
    try {
      const DatabaseRows rows(database, row);
      rows.view(rows.subject(1), 1, {});
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(refusal(), "no error");
  const std::string rest = read_text(directory / "grasps/rest.toml");
  write_text(directory / "grasps/rest.toml", "index_deg = { mcp = 50 }\n");
  EXPECT_THAT(refusal(), HasSubstr("joint angles"));
  write_text(directory / "grasps/rest.toml", rest);
  std::ofstream(directory / "grasps/09_palmar_pinch.toml", std::ios::app) << "# changed\n";
  EXPECT_THAT(refusal(), HasSubstr("09_palmar_pinch.toml"));
  fs::remove(directory / "male.glb");
  EXPECT_THAT(refusal(), HasSubstr("male.glb"));
}

}  // namespace
}  // namespace graspdb
