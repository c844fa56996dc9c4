// SPDX-License-Identifier: MIT
// Every rule of the COCO keypoints format, on files as another program reads them.
#include "graspdb/pictures/export_coco.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

#include "coco_text.h"
#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/features/hog.h"
#include "graspdb/renderer/image_io.h"
#include "small_database.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;

constexpr int kResolution = 96;

std::vector<std::size_t> all_rows() {
  std::vector<std::size_t> rows(testing::small_database().rows());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  return rows;
}

Mask decode(const json& rle) {
  Mask mask(rle.at("size").at(1), rle.at("size").at(0));
  std::size_t at = 0;
  bool inside = false;
  for (const std::size_t run : rle.at("counts")) {
    for (const std::size_t end = at + run; at < end; ++at) {
      const auto height = static_cast<std::size_t>(mask.height());
      mask.at(static_cast<int>(at / height), static_cast<int>(at % height)) = inside ? 255 : 0;
    }
    inside = !inside;
  }
  EXPECT_EQ(at, mask.size());
  return mask;
}

TEST(RunLengths, GoDownTheColumnsAndStartWithWhatIsOutside) {
  Image<std::uint8_t> image(3, 2);
  image.at(1, 0) = image.at(1, 1) = image.at(2, 0) = 1;
  EXPECT_THAT(run_lengths(image, 1), ::testing::ElementsAre(2, 3, 1));
  image.at(0, 0) = 1;
  EXPECT_THAT(run_lengths(image, 1), ::testing::ElementsAre(0, 1, 1, 3, 1));
  image.at(0, 0) = 2;
  EXPECT_THAT(run_lengths(image, 1), ::testing::ElementsAre(2, 3, 1));
  EXPECT_THAT(run_lengths(Image<std::uint8_t>(3, 2), 1), ::testing::ElementsAre(6));
}

class Coco : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    directory_ = new testing::TemporaryDirectory;
    export_coco(testing::small_database(), *directory_ / "coco",
                {.rows = all_rows(), .resolution = kResolution, .amodal = true, .depth = true});
    coco_ = new json(json::parse(read_text(*directory_ / "coco/annotations.json")));
  }
  static void TearDownTestSuite() {
    delete coco_;
    delete directory_;
  }
  static GrayImage picture(const char* folder, const json& annotation) {
    const std::size_t row = annotation.at("image_id");
    return read_gray(*directory_ / "coco" / folder / fmt::format("{:012}.png", row));
  }
  static const json& annotations() { return coco_->at("annotations"); }

  static inline testing::TemporaryDirectory* directory_ = nullptr;
  static inline json* coco_ = nullptr;
};

TEST_F(Coco, HasTheKeysOfTheFormatWithTheirTypes) {
  for (const char* key : {"licenses", "images", "annotations", "categories"}) {
    EXPECT_TRUE(coco_->at(key).is_array()) << key;
  }
  EXPECT_TRUE(coco_->at("info").is_object());
  for (const json& a : annotations()) {
    for (const char* key : {"id", "image_id", "category_id", "area", "iscrowd", "num_keypoints"}) {
      EXPECT_TRUE(a.at(key).is_number_integer()) << key;
    }
    EXPECT_EQ(a.at("bbox").size(), 4u);
    EXPECT_EQ(a.at("keypoints").size(), 63u);
    EXPECT_EQ(a.at("iscrowd"), 0);
    EXPECT_EQ(a.at("category_id"), 1);
    EXPECT_EQ(a.at("graspdb").at("keypoints_m").size(), 63u);
    EXPECT_EQ(a.at("graspdb").at("angles").size(), 28u);
  }
}

TEST_F(Coco, NamesTheKeypointsAndCountsTheSkeletonFromOne) {
  ASSERT_EQ(coco_->at("categories").size(), 1u);
  const json& hand = coco_->at("categories").at(0);
  EXPECT_EQ(hand.at("name"), "hand");
  ASSERT_EQ(hand.at("keypoints").size(), 21u);
  EXPECT_EQ(hand.at("keypoints").at(0), "wrist");
  EXPECT_EQ(hand.at("keypoints").at(20), "little_tip");
  ASSERT_EQ(hand.at("skeleton").size(), 20u);
  std::set<int> reached = {1};
  for (const json& bone : hand.at("skeleton")) {
    EXPECT_TRUE(reached.contains(bone.at(0).get<int>())) << bone;
    EXPECT_TRUE(reached.insert(bone.at(1).get<int>()).second) << bone;
  }
  EXPECT_EQ(*reached.rbegin(), 21);
  EXPECT_EQ(reached.size(), 21u);
}

TEST_F(Coco, IdsAreUniqueAboveZeroAndNameImagesThatAreThere) {
  std::set<std::size_t> images, ids;
  for (const json& image : coco_->at("images")) {
    EXPECT_TRUE(images.insert(image.at("id").get<std::size_t>()).second);
    const fs::path file = *directory_ / "coco/images" / image.at("file_name").get<std::string>();
    const GrayImage shown = read_gray(file);
    EXPECT_EQ(shown.width(), image.at("width"));
    EXPECT_EQ(shown.height(), image.at("height"));
  }
  for (const json& a : annotations()) {
    EXPECT_TRUE(ids.insert(a.at("id").get<std::size_t>()).second);
    EXPECT_TRUE(images.contains(a.at("image_id").get<std::size_t>()));
  }
  EXPECT_EQ(images.size(), 96u);
  EXPECT_EQ(ids.size(), 96u);
  EXPECT_GT(*ids.begin(), 0u);
}

TEST_F(Coco, SegmentationAreaAndBoxAreOfTheMaskPicture) {
  for (const json& a : annotations()) {
    const Mask decoded = decode(a.at("segmentation"));
    GrayImage mask = picture("masks", a);
    for (std::uint8_t& pixel : mask) pixel = pixel == kHandSurface ? 255 : 0;
    ASSERT_EQ(decoded, mask);
    EXPECT_EQ(std::count(mask.begin(), mask.end(), 255), a.at("area"));
    const Box box = tight_box(mask).value();
    EXPECT_EQ(a.at("bbox"), (json{box.x, box.y, box.width, box.height}));
  }
}

TEST_F(Coco, KeypointsAreThePointsInSpaceSeenThroughTheCamera) {
  for (const json& a : annotations()) {
    const auto points = a.at("keypoints").get<std::vector<double>>();
    const auto space = a.at("graspdb").at("keypoints_m").get<std::vector<double>>();
    const auto k = a.at("graspdb").at("K").get<std::vector<double>>();
    int labelled = 0;
    for (std::size_t i = 0; i < points.size(); i += 3) {
      const double v = points[i + 2];
      EXPECT_TRUE(v == 0 || v == 1 || v == 2);
      if (v == 0) continue;
      ++labelled;
      EXPECT_NEAR(k[0] * space[i] / space[i + 2] + k[2], points[i], 0.01);
      EXPECT_NEAR(k[4] * space[i + 1] / space[i + 2] + k[5], points[i + 1], 0.01);
      EXPECT_TRUE(points[i] > -0.5 && points[i] < kResolution - 0.5);
    }
    EXPECT_EQ(labelled, a.at("num_keypoints"));
    const auto wrist = a.at("graspdb").at("wrist_m").get<std::vector<double>>();
    EXPECT_TRUE(std::equal(wrist.begin(), wrist.end(), space.begin()));
  }
}

TEST_F(Coco, AVisibleKeypointLiesOnTheVisibleHand) {
  int visible = 0, hidden = 0, hidden_by_object = 0;
  for (const json& a : annotations()) {
    const GrayImage mask = picture("masks", a);
    const auto points = a.at("keypoints").get<std::vector<double>>();
    for (std::size_t i = 0; i < points.size(); i += 3) {
      const int x = static_cast<int>(std::lround(points[i]));
      const int y = static_cast<int>(std::lround(points[i + 1]));
      if (points[i + 2] == 1) {
        ++hidden;
        hidden_by_object += mask.at(x, y) == kObjectSurface ? 1 : 0;
        continue;
      }
      ++visible;
      bool on_hand = false;  // a tip is a point of the outline: the next pixel is near enough
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) on_hand |= mask.at(x + dx, y + dy) == kHandSurface;
      }
      EXPECT_TRUE(on_hand) << a.at("image_id") << " keypoint " << i / 3;
    }
  }
  EXPECT_GT(visible, 600);
  EXPECT_GT(hidden, 300);
  EXPECT_GT(hidden_by_object, 40);
}

TEST_F(Coco, AnnotationsSayWhichRowTheyAre) {
  const Database& database = testing::small_database();
  for (const json& a : annotations()) {
    const json& ours = a.at("graspdb");
    const std::size_t row = ours.at("row");
    EXPECT_EQ(row, a.at("image_id"));
    EXPECT_EQ(ours.at("grasp"), database.grasp(row));
    EXPECT_EQ(ours.at("step"), database.step(row));
    EXPECT_EQ(ours.at("view"), database.view(row));
    EXPECT_EQ(ours.at("variant"), database.variant(row) == 0 ? "held" : "free");
    for (std::size_t i = 0; i < kAngleCount; ++i) {
      EXPECT_NEAR(ours.at("angles").at(i).get<double>(), database.label(row)[3 + i], 1e-6);
    }
  }
}

TEST_F(Coco, AmodalMasksHoldTheVisibleOnes) {
  for (const json& a : annotations()) {
    const GrayImage mask = picture("masks", a);
    const GrayImage hand = picture("hand_amodal", a), object = picture("object_amodal", a);
    for (std::size_t i = 0; i < mask.size(); ++i) {
      if (mask.data()[i] == kHandSurface) {
        EXPECT_EQ(hand.data()[i], 255);
      }
      if (mask.data()[i] == kObjectSurface) {
        EXPECT_EQ(object.data()[i], 255);
      }
    }
  }
}

TEST_F(Coco, TheNumberOfThreadsChangesNoByteAndAFewRowsAreThose) {
  const std::vector<std::size_t> rows = {3, 50, 51};
  for (const int threads : {1, 3}) {
    export_coco(testing::small_database(), *directory_ / std::to_string(threads),
                {.rows = rows, .resolution = kResolution, .threads = threads});
  }
  EXPECT_EQ(read_text(*directory_ / "1/annotations.json"),
            read_text(*directory_ / "3/annotations.json"));
  const json few = json::parse(read_text(*directory_ / "1/annotations.json"));
  ASSERT_EQ(few.at("annotations").size(), 3u);
  EXPECT_EQ(few.at("annotations").at(1), annotations().at(50));
  EXPECT_FALSE(fs::exists(*directory_ / "1/depth"));
}

TEST_F(Coco, AnEarlierExportIsReplacedAndAnythingElseRefused) {
  const Database& database = testing::small_database();
  const fs::path out = *directory_ / "again";
  export_coco(database, out, {.rows = {1, 2}});
  export_coco(database, out, {.rows = {2}});
  EXPECT_FALSE(fs::exists(out / "images/000000000001.png"));
  EXPECT_TRUE(fs::exists(out / "images/000000000002.png"));
  write_text(*directory_ / "mine/images/holiday.png", "mine");
  try {
    export_coco(database, *directory_ / "mine", {.rows = {1}});
    ADD_FAILURE() << "a foreign folder was taken";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("mine"));
  }
  EXPECT_EQ(read_text(*directory_ / "mine/images/holiday.png"), "mine");
}

TEST_F(Coco, AnExportThatEndsEarlyHasNoAnnotations) {
  const fs::path out = *directory_ / "ended";
  export_coco(testing::small_database(), out, {.rows = {1}});
  const Progress end = [](std::size_t done, std::size_t) {
    if (done == 5) throw Error("ended");
  };
  EXPECT_THROW(export_coco(testing::small_database(), out, {.rows = all_rows(), .progress = end}),
               Error);
  EXPECT_TRUE(fs::exists(out / "images"));
  EXPECT_FALSE(fs::exists(out / "annotations.json"));
}

}  // namespace
}  // namespace graspdb
