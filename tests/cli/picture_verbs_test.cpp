// SPDX-License-Identifier: MIT
// render, export and info --sheet: what they write and how they refuse.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "graspdb/core/file.h"
#include "graspdb/renderer/image_io.h"
#include "program.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using testing::run_program;

class PictureVerbs : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    directory_ = new testing::TemporaryDirectory;
    ASSERT_EQ(testing::build_tiny(*directory_ / "tiny.graspdb").code, 0);
  }
  static void TearDownTestSuite() { delete directory_; }

  static std::string in(const std::string& name) { return (*directory_ / name).string(); }
  static void expect_refused(const std::string& arguments, int code, const std::string& told) {
    const auto outcome = run_program(arguments + " --out " + in("refused"));
    EXPECT_EQ(outcome.code, code) << arguments;
    EXPECT_THAT(outcome.err, HasSubstr(told)) << arguments;
    EXPECT_FALSE(std::filesystem::exists(in("refused"))) << arguments;
  }

  static inline testing::TemporaryDirectory* directory_ = nullptr;
};

TEST_F(PictureVerbs, AGraspAndTheRowOfItAreOnePicture) {
  const auto grasp = run_program(
      "render --grasp 9 --steps 1 --step 1 --views 24 --view 17 "
      "--resolution 32 --out " +
      in("grasp"));
  ASSERT_EQ(grasp.code, 0) << grasp.err;
  const auto row =
      run_program("render --db " + in("tiny.graspdb") + " --row 17 --out " + in("row"));
  ASSERT_EQ(row.code, 0) << row.err;
  for (const char* file : {"shading.png", "label.png", "part.png", "depth.png", "depth.exr",
                           "normal.exr", "hand_amodal.png", "object_amodal.png"}) {
    EXPECT_TRUE(read_text(in("grasp") + "/" + file) == read_text(in("row") + "/" + file)) << file;
  }
  const json of_grasp = json::parse(read_text(in("grasp/view.json")));
  const json of_row = json::parse(read_text(in("row/view.json")));
  EXPECT_EQ(of_row.at("source").at("row"), 17);
  EXPECT_EQ(of_row.at("keypoints"), of_grasp.at("keypoints"));
  EXPECT_EQ(of_row.at("source").at("grasp_name"), "Palmar Pinch");
  EXPECT_GT(read_color(in("row/sheet.png")).width(), 1000);
}

TEST_F(PictureVerbs, APoseIsReadFromAFile) {
  write_text(in("pose.toml"), "view_deg = [0, 0, 0]\n[angles_deg]\nindex_pip_flexion = 40\n");
  const auto outcome =
      run_program("render --pose " + in("pose.toml") + " --hand " +
                  GRASPDB_SOURCE_DIR "/assets/hands/child.glb --out " + in("pose"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json view = json::parse(read_text(in("pose/view.json")));
  EXPECT_EQ(view.at("source").at("hand"), "child");
  EXPECT_NEAR(view.at("angles").at("index_pip_flexion").get<double>(), 0.698132, 1e-6);
  EXPECT_TRUE(view.at("camera_from_object").is_null());
}

TEST_F(PictureVerbs, OneThingIsRenderedAtATime) {
  const std::string database = in("tiny.graspdb");
  expect_refused("render", 2, "--grasp");
  expect_refused("render --grasp 9 --db " + database, 2, "--db");
  expect_refused("render --db " + database, 2, "--row");
  expect_refused("render --db " + database + " --row 0 --views 3", 2, "--views");
  expect_refused("render --grasp 77", 1, "77");
  expect_refused("render --grasp 9 --step 6", 1, "--step");
  expect_refused("render --grasp 9 --view 648", 1, "--view");
  expect_refused("render --db " + database + " --row 24", 1, "--row");
}

TEST_F(PictureVerbs, ChosenRowsAreExported) {
  const auto outcome = run_program("export " + in("tiny.graspdb") +
                                   " --format coco --rows 2-5,9,4 --out " + in("coco"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::vector<int> rows;
  const json coco = json::parse(read_text(in("coco/annotations.json")));
  for (const json& a : coco.at("annotations")) {
    rows.push_back(a.at("image_id"));
  }
  EXPECT_THAT(rows, ::testing::ElementsAre(2, 3, 4, 5, 9));
  const auto sampled = [&](const char* seed) {
    run_program("export " + in("tiny.graspdb") + " --sample 5 --seed " + seed + " --out " +
                in("sample"));
    return json::parse(read_text(in("sample/annotations.json"))).at("images");
  };
  EXPECT_EQ(sampled("1").size(), 5u);
  EXPECT_EQ(sampled("1"), sampled("1"));
  EXPECT_NE(sampled("1"), sampled("2"));
}

TEST_F(PictureVerbs, RowsThatAreNotThereAreNamed) {
  const std::string exporting = "export " + in("tiny.graspdb") + " --format coco ";
  for (const char* rows : {"24", "3-2", "0-24", "1,", "x", "1-", "-1"}) {
    expect_refused(exporting + "--rows=" + rows, 1, "--rows");
  }
  expect_refused(exporting + "--grasp 3", 1, "none of these");
  const auto without = run_program(exporting);
  EXPECT_EQ(without.code, 2);
  EXPECT_THAT(without.err, HasSubstr("--out"));
  expect_refused("export " + in("tiny.graspdb") + " --format yolo --out x", 2, "--format");
}

TEST_F(PictureVerbs, ASheetShowsRowsInEveryTile) {
  const auto outcome =
      run_program("info " + in("tiny.graspdb") + " --rows 8 --sheet " + in("sheet.png"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const GrayImage page = read_gray(in("sheet.png"));
  const int width = page.width() / 4, height = (page.height() - 26) / 2;
  for (int tile = 0; tile < 8; ++tile) {
    int dark = 0;
    for (int y = 0; y < 144; ++y) {
      for (int x = 0; x < 144; ++x) {
        dark += page.at(tile % 4 * width + x, 26 + tile / 4 * height + y) < 235 ? 1 : 0;
      }
    }
    EXPECT_GT(dark, 1500) << tile;
  }
}

// A picture of row 17 as a large frame, and its mask.
TEST_F(PictureVerbs, ThePictureOfARowIsNearestToThatRow) {
  ASSERT_EQ(run_program("render --resolution 256 --db " + in("tiny.graspdb") + " --row 17 --out " +
                        in("asked"))
                .code,
            0);
  GrayImage mask = read_gray(in("asked/label.png"));
  for (std::uint8_t& pixel : mask) pixel = pixel == 1 ? 255 : 0;
  write_png(in("mask.png"), mask);
  const std::string query = "query " + in("tiny.graspdb") + " " + in("asked/shading.png");
  const auto outcome =
      run_program(query + " -k 3 --json --mask " + in("mask.png") + " --out " + in("near.png"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json answer = json::parse(outcome.out);
  ASSERT_EQ(answer.at("neighbours").size(), 3u);
  EXPECT_EQ(answer.at("neighbours").at(0).at("row"), 17);
  EXPECT_EQ(answer.at("neighbours").at(0).at("grasp").at("id"), 9);
  EXPECT_LT(answer.at("neighbours").at(0).at("distance"),
            answer.at("neighbours").at(1).at("distance"));
  EXPECT_GT(read_color(in("near.png")).width(), 500);
  const auto gray = run_program(query + " --finder redness");  // has no skin colour
  EXPECT_EQ(gray.code, 1);
  EXPECT_THAT(gray.err, HasSubstr("a hand"));
  const auto other_size = run_program(query + " --mask " + in("near.png"));
  EXPECT_EQ(other_size.code, 1);
  EXPECT_THAT(other_size.err, HasSubstr("256 x 256"));
}

TEST_F(PictureVerbs, EverySceneHasAFolder) {
  write_text(in("right.toml"), "hands = [\"assets/hands/male.glb\"]\nmade_hands = 0\n");
  const auto outcome = run_program(
      "scenes --first 41 --count 2 --frames 1 --width 64 --height 48 "
      "--config " +
      in("right.toml") + " --out " + in("scenes"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const char* number : {"000041", "000042"}) {
    const std::string folder = in("scenes") + "/" + number;
    EXPECT_EQ(json::parse(read_text(folder + "/meshes.json")).at("camera").at("width_px"), 64);
    EXPECT_EQ(read_gray(folder + "/labels/000000.png").height(), 48);
  }
}

TEST_F(PictureVerbs, SamplesHaveTheHogsThatAreAskedFor) {
  write_text(in("right.toml"), "hands = [\"assets/hands/male.glb\"]\nmade_hands = 0\n");
  const auto outcome = run_program("samples --count 2 --hog paper --config " + in("right.toml") +
                                   " --out " + in("samples.safetensors"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(read_text(in("samples.safetensors")), HasSubstr("\"hog\""));
}

}  // namespace
}  // namespace graspdb
