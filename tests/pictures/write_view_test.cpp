// SPDX-License-Identifier: MIT
#include "graspdb/pictures/write_view.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "graspdb/core/file.h"
#include "graspdb/pictures/database_rows.h"
#include "graspdb/renderer/image_io.h"
#include "small_database.h"

namespace graspdb {
namespace {

using nlohmann::json;

TEST(WriteView, DepthIsWholeMillimetersAndNothingIsZero) {
  Image<float> meters(4, 1);
  meters.at(0, 0) = 0.7004F;
  meters.at(1, 0) = 0.7006F;
  meters.at(2, 0) = std::numeric_limits<float>::infinity();
  meters.at(3, 0) = 100;
  const auto mm = depth_in_mm(meters);
  EXPECT_THAT(std::vector(mm.begin(), mm.end()), ::testing::ElementsAre(700, 701, 0, 65535));
}

TEST(WriteView, AFolderHoldsEveryLayerAndWhatTheyMean) {
  const Database& database = testing::small_database();
  const DatabaseRows rows(database, std::vector<std::size_t>{30});
  const LabelledView view = rows.view(rows.subject(30), 30, kAllLayers);
  const testing::TemporaryDirectory directory;
  write_view(directory / "v", view,
             {.hand = "male", .variant = "held", .grasp = 9, .step = 1, .steps = 2, .view = 6});
  EXPECT_EQ(read_gray(directory / "v/shading.png"), view.picture.shading);
  EXPECT_EQ(read_gray(directory / "v/label.png"), view.picture.label);
  EXPECT_EQ(read_gray(directory / "v/part.png"), view.picture.part);
  EXPECT_EQ(read_gray(directory / "v/hand_amodal.png"), view.picture.hand_amodal);
  EXPECT_EQ(read_gray(directory / "v/object_amodal.png"), view.picture.object_amodal);
  for (const char* file : {"depth.png", "depth.exr", "normal.exr"}) {
    EXPECT_GT(std::filesystem::file_size(directory / "v" / file), 100u) << file;
  }
  const json written = json::parse(read_text(directory / "v/view.json"));
  EXPECT_EQ(written.at("source").at("grasp"), 9);
  EXPECT_TRUE(written.at("source").at("row").is_null());
  EXPECT_EQ(written.at("hand").at("visible_px"), view.hand.visible);
  EXPECT_EQ(written.at("object").at("amodal_px"), view.object.amodal);
  EXPECT_EQ(written.at("parts").size(), 22u);
  EXPECT_EQ(written.at("angles").size(), 28u);
  EXPECT_NEAR(written.at("angles").at("ring_pip_flexion").get<double>(),
              view.angles[finger_angle(2, kPipFlexion)], 1e-6);
}

TEST(WriteView, TheKeypointsOfAViewProjectOntoTheirPixels) {
  const Database& database = testing::small_database();
  const DatabaseRows rows(database, std::vector<std::size_t>{2});
  const testing::TemporaryDirectory directory;
  write_view(directory / "v", rows.view(rows.subject(2), 2, kAllLayers), {});
  const json view = json::parse(read_text(directory / "v/view.json"));
  const auto k = view.at("camera").at("K").get<std::vector<double>>();
  ASSERT_EQ(view.at("keypoints").size(), 21u);
  for (const json& point : view.at("keypoints")) {
    const auto m = point.at("m").get<std::vector<double>>();
    EXPECT_NEAR(k[0] * m[0] / m[2] + k[2], point.at("px")[0].get<double>(), 0.01);
    EXPECT_NEAR(k[4] * m[1] / m[2] + k[5], point.at("px")[1].get<double>(), 0.01);
  }
  EXPECT_EQ(view.at("wrist_m"), view.at("keypoints")[0].at("m"));
}

}  // namespace
}  // namespace graspdb
