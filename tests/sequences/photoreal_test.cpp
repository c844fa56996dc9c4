// SPDX-License-Identifier: MIT
// Frames of another renderer: the hand is found by its colour, the truth is the sequence's.
#include "graspdb/sequences/photoreal.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>

#include "features/color_finder.h"
#include "graspdb/core/error.h"
#include "graspdb/features/hand_finder.h"
#include "graspdb/features/hand_follower.h"
#include "graspdb/features/hog.h"
#include "graspdb/features/segmentation.h"
#include "graspdb/renderer/image_io.h"
#include "support/temporary_directory.h"
#include "support/tripod_sequence.h"

namespace graspdb {
namespace {

using ::testing::HasSubstr;

// Of another colour than its object, and without it.
SequenceSpec empty_tripod() {
  SequenceSpec spec = testing::tripod_sequence();
  spec.camera.fx = spec.camera.fy = 400;
  spec.look.skin_bgr = {110, 145, 205};
  spec.look.object_bgr = {150, 90, 40};
  spec.object_visible = false;
  spec.keyframes = {{.time = 0, .closure = 0, .view = {0.2, 0, 0}, .palm = {0, 0, 0.45}},
                    {.time = 0.3, .closure = 1, .view = {0.4, 0, 0}, .palm = {0.02, 0.01, 0.5}}};
  return spec;
}

void write_jpeg(const std::filesystem::path& file, ColorImage color) {
  std::filesystem::create_directories(file.parent_path());
  cv::imwrite(file, cv::Mat(color.height(), color.width(), CV_8UC3, color.data()));
}

class Photoreal : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { renderer_ = std::make_unique<SequenceRenderer>(empty_tripod()); }
  static void TearDownTestSuite() { renderer_.reset(); }

  std::filesystem::path frame(int i) const {
    return folder_ / "tripod" / fmt::format("{:06}.jpg", i);
  }
  // Its own frames, as if another renderer had made them.
  void write_own_frames(int count) const {
    for (int i = 0; i < count; ++i) write_jpeg(frame(i), renderer_->render(i).color);
  }
  bool has_frames() const { return has_photoreal_frames(renderer_->spec(), folder_.path()); }
  SequenceFrames frames() const { return photoreal_frames(*renderer_, folder_.path()); }

  static std::unique_ptr<SequenceRenderer> renderer_;
  testing::TemporaryDirectory folder_;
};
std::unique_ptr<SequenceRenderer> Photoreal::renderer_;

template <typename Function>
std::string message(const Function& function) {
  try {
    function();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST_F(Photoreal, TheHandIsTheOneThatItsColorTells) {
  write_own_frames(4);
  ASSERT_TRUE(has_frames());
  const SequenceFrames photos = frames();
  EXPECT_EQ(photos.kind, FrameKind::kPhotoreal);
  for (std::size_t i = 0; i < 4; ++i) {
    const Mask found = find_hand(read_color(frame(static_cast<int>(i)))).hand;
    EXPECT_EQ(photos.hand[i], found);
    EXPECT_GT(photos.found[i].iou, 0.75);  // an arm that does not reach the border is not cut
    EXPECT_LT(photos.found[i].iou, 1);     // it is not the true mask
    EXPECT_FALSE(photos.found[i].missed);
    EXPECT_EQ(photos.truth[i].joints, renderer_->truth(static_cast<int>(i)).joints);
  }
}

TEST_F(Photoreal, ALearnedFinderFollowsTheHandAsInAVideo) {
  write_own_frames(4);
  const FinderOptions finder{.net = std::make_shared<HandFinder>(testing::color_finder())};
  const SequenceFrames photos =
      photoreal_frames(*renderer_, folder_.path(), FrameKind::kPhotoreal, finder);
  HandFollower follower(finder);
  ASSERT_EQ(photos.arm.size(), 4U);
  for (int i = 0; i < 4; ++i) {
    const FoundHand found = follower.next(read_color(frame(i)));
    const auto at = static_cast<std::size_t>(i);
    EXPECT_EQ(photos.hand[at], found.hand);
    EXPECT_EQ(photos.arm[at], found.arm);
    EXPECT_FALSE(photos.found[at].missed);
    EXPECT_GT(photos.found[at].iou, 0.05);  // what is red or grey is hand to it
    EXPECT_LT(photos.found[at].iou, 0.9);
  }
}

TEST_F(Photoreal, TrueMasksAreThoseOfTheSequence) {
  write_own_frames(4);
  const SequenceFrames photos =
      photoreal_frames(*renderer_, folder_.path(), FrameKind::kPhotorealTrueMasks);
  EXPECT_EQ(photos.kind, FrameKind::kPhotorealTrueMasks);
  EXPECT_TRUE(photos.found.empty());
  const SequenceFrames rendered = render_frames(*renderer_);
  EXPECT_EQ(photos.hand, rendered.hand);
  EXPECT_EQ(photos.gray, frames().gray);
}

TEST_F(Photoreal, APictureWithoutSkinShowsNoHand) {
  write_own_frames(3);
  write_jpeg(frame(3), ColorImage(320, 240, {120, 120, 120}));
  const SequenceFrames photos = frames();
  EXPECT_FALSE(tight_box(photos.hand[3]));
  EXPECT_EQ(photos.found[3].iou, 0);
  EXPECT_TRUE(photos.found[3].missed);
  EXPECT_TRUE(tight_box(photos.hand[2]));
}

TEST_F(Photoreal, AFolderIsWholeOrAbsent) {
  EXPECT_FALSE(has_frames());
  write_own_frames(3);
  EXPECT_THAT(message([&] { has_frames(); }), HasSubstr("4 pictures"));
  write_jpeg(folder_ / "tripod/000004.jpg", ColorImage(320, 240));
  EXPECT_TRUE(has_frames());  // as many, but not the right ones
  EXPECT_THAT(message([&] { frames(); }), HasSubstr("000003.jpg"));
  write_jpeg(frame(3), ColorImage(320, 200));
  EXPECT_THAT(message([&] { frames(); }), HasSubstr("320 x 240"));
}

TEST(MaskIou, CountsPixelsOfBothAndOfEither) {
  Mask a(4, 1), b(4, 1);
  EXPECT_TRUE(std::isnan(mask_iou(a, b)));
  a.at(0, 0) = a.at(1, 0) = 255;
  EXPECT_EQ(mask_iou(a, b), 0);
  b.at(1, 0) = b.at(2, 0) = 255;
  EXPECT_DOUBLE_EQ(mask_iou(a, b), 1.0 / 3);
  EXPECT_EQ(mask_iou(a, a), 1);
}

}  // namespace
}  // namespace graspdb
