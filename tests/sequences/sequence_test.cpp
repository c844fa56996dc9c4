// SPDX-License-Identifier: MIT
#include "graspdb/sequences/sequence.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/toml.h"
#include "graspdb/grasps/closing.h"
#include "graspdb/hand/rig/rig.h"
#include "graspdb/hand/turns.h"
#include "graspdb/renderer/image_io.h"
#include "support/source_folder.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using ::testing::HasSubstr;

using testing::kSource;
const std::filesystem::path kHand = kSource / "assets/hands/male.glb";

// A folder with the bottle of the test set, closed on the male hand once for all tests.
class Bottle {
 public:
  Bottle() {
    for (const char* file : {"bottle.seq.toml", "bottle.grasp.toml", "rest.toml"}) {
      std::filesystem::copy_file(kSource / "sequences/test" / file, folder_ / file);
    }
    const Grasp grasp = load_grasp(folder_ / "bottle.grasp.toml");
    const Hand hand = load_hand(kHand);
    keep_closed_poses({grasp}, hand, {close_grasp(grasp, hand)});
  }
  std::filesystem::path file() const { return folder_ / "bottle.seq.toml"; }

 private:
  testing::TemporaryDirectory folder_;
};

// Small and short.
SequenceSpec short_spec() {
  static const Bottle bottle;
  SequenceSpec spec = load_sequence(bottle.file(), kHand);
  spec.camera = {.width = 160, .height = 120, .fx = 150, .fy = 150, .cx = 79.5, .cy = 59.5};
  spec.keyframes = {
      {.time = 0, .closure = 0, .view = {0, 0, 0}, .palm = {0, 0, 0.5}},
      {.time = 0.4, .closure = 1, .view = {0, 0, radians(40)}, .palm = {0.02, 0, 0.6}}};
  return spec;
}

TEST(SequenceView, ZeroIsTheBackOfAnUprightHand) {
  const Eigen::Matrix3d rotation = rotation_from_turns({0, 0, 0});
  EXPECT_NEAR(rotation.col(1).y(), -1, 1e-12);  // distal is up in the picture
  EXPECT_NEAR(rotation.col(2).z(), -1, 1e-12);  // dorsal towards the camera
  EXPECT_NEAR(rotation_from_turns({kPi, 0, 0}).col(2).z(), 1, 1e-12);  // half a turn shows the palm
}

class ShortSequence : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { renderer_ = std::make_unique<SequenceRenderer>(short_spec()); }
  static void TearDownTestSuite() { renderer_.reset(); }
  static std::unique_ptr<SequenceRenderer> renderer_;
};
std::unique_ptr<SequenceRenderer> ShortSequence::renderer_;

TEST_F(ShortSequence, KeyframesAreReachedAndBlended) {
  ASSERT_EQ(renderer_->spec().frame_count(), 5);
  EXPECT_LT((renderer_->truth(0).angles - renderer_->spec().rest).norm(), 1e-9);
  const FrameTruth middle = renderer_->truth(2);
  EXPECT_NEAR(middle.closure, 0.5, 1e-9);
  EXPECT_NEAR(
      degrees(angle_between(middle.camera_from_hand.rotation, rotation_from_turns({0, 0, 0}))), 20,
      1e-6);
  EXPECT_EQ(middle.joints.col(0), middle.camera_from_hand.translation);
}

// Tips lie on the skin, so that their pixel may be just outside.
bool shows_hand_near(const SequenceFrame& frame, int x, int y) {
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (frame.hand.at(x + dx, y + dy) == 255 || frame.object.at(x + dx, y + dy) == 255)
        return true;
    }
  }
  return false;
}

TEST_F(ShortSequence, TruthProjectsOntoTheHand) {
  const SequenceFrame frame = renderer_->render(0);
  for (int i = 0; i < kKeypointCount; ++i) {
    const Eigen::Vector2d p = renderer_->spec().camera.project(frame.truth.joints.col(i));
    EXPECT_TRUE(shows_hand_near(frame, static_cast<int>(std::lround(p.x())),
                                static_cast<int>(std::lround(p.y()))))
        << keypoint_name(i);
  }
}

TEST_F(ShortSequence, HandAndObjectDoNotOverlapAndBothAreSeen) {
  const SequenceFrame frame = renderer_->render(4);
  int hand = 0, object = 0;
  for (std::size_t i = 0; i < frame.hand.size(); ++i) {
    EXPECT_FALSE(frame.hand.data()[i] == 255 && frame.object.data()[i] == 255);
    hand += frame.hand.data()[i] == 255;
    object += frame.object.data()[i] == 255;
  }
  EXPECT_GT(hand, 300);
  EXPECT_GT(object, 100);
}

TEST_F(ShortSequence, AnotherFrameRateShowsTheSameMotionInOtherSteps) {
  SequenceSpec spec = short_spec();
  spec.frames_per_second = 30;
  const SequenceRenderer faster(spec);
  ASSERT_EQ(spec.frame_count(), 13);  // 0.4 s
  for (int i = 0; i < renderer_->spec().frame_count(); ++i) {
    const FrameTruth slow = renderer_->truth(i), fast = faster.truth(3 * i);
    EXPECT_EQ(fast.time, slow.time);
    EXPECT_EQ(fast.closure, slow.closure);
    EXPECT_EQ(fast.angles, slow.angles);
    EXPECT_EQ(fast.joints, slow.joints);
  }
  EXPECT_EQ(faster.render(3).hand, renderer_->render(1).hand);
}

TEST_F(ShortSequence, NoiseGoesByTheFramesNumberAtAnyRate) {
  SequenceSpec still = short_spec();
  still.keyframes[1] = still.keyframes[0];
  still.keyframes[1].time = 0.4;
  const SequenceRenderer slow(still);
  still.frames_per_second = 30;
  const SequenceRenderer fast(still);
  EXPECT_EQ(fast.render(2).color, slow.render(2).color);
  EXPECT_NE(fast.render(2).color, fast.render(3).color);
}

TEST_F(ShortSequence, WhatIsWrittenIsReadBack) {
  const testing::TemporaryDirectory directory;
  write_sequence(*renderer_, directory.path(), {.alpha_percent = 1, .seed = 3});
  const WrittenSequence back = read_sequence(directory.path());
  ASSERT_EQ(back.truth.size(), 5u);
  EXPECT_EQ(back.camera.fx, 150);
  EXPECT_EQ(back.truth[3].angles, renderer_->truth(3).angles);
  EXPECT_EQ(back.truth[3].joints, renderer_->truth(3).joints);
  EXPECT_EQ(read_gray(directory / "masks/000003.png"), renderer_->render(3).hand);
  EXPECT_NE(read_gray(directory / "noisy/000003.png"), renderer_->render(3).hand);
  EXPECT_EQ(read_color(directory / "frames/000002.png"), renderer_->render(2).color);
}

TEST_F(ShortSequence, WhatWasNotWrittenSoIsRefusedWithFileAndKey) {
  const testing::TemporaryDirectory directory;
  write_sequence(*renderer_, directory.path(), {});
  const auto expect_refused = [&](const char* name, const std::string& from, const std::string& to,
                                  const std::string& key) {
    const std::filesystem::path file = directory / name;
    const std::string good = read_text(file);
    const std::size_t at = good.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    write_text(file, std::string(good).replace(at, from.size(), to));
    try {
      read_sequence(directory.path());
      ADD_FAILURE() << "accepted: " << to;
    } catch (const Error& error) {
      EXPECT_EQ(error.fault().file, file.string());
      EXPECT_EQ(error.fault().key, key) << error.what();
    }
    write_text(file, good);
  };
  const char* header = "sequence.json";
  for (const char* width : {"1e99", "1e3", "99999999999999999999", "4294967456", "0", "-5",
                            "100001", "true", "null", "\"160\""}) {
    expect_refused(header, "\"width_px\": 160", std::string("\"width_px\": ") + width,
                   "camera.width_px");
  }
  expect_refused(header, "\"height_px\"", "\"hight_px\"", "camera.height_px");
  expect_refused(header, "\"fx_px\": 150.0", "\"fx_px\": 0", "camera.fx_px");
  expect_refused(header, "\"cx_px\": 79.5", "\"cx_px\": null", "camera.cx_px");
  expect_refused(header, "\"frames_per_second\": 10.0", "\"frames_per_second\": -1",
                 "frames_per_second");
  expect_refused(header, "\"camera\"", "\"kamera\"", "camera");
  expect_refused(header, "{", "", "");
  const char* truth = "truth.jsonl";
  expect_refused(truth, "\"angles\":[", "\"angles\":[0,", "line 1.angles");
  expect_refused(truth, "\"wrist_m\":[", "\"wrist_m\":[1e999,", "line 1");
  expect_refused(truth, "\"frame\":1", "\"closure\":1", "line 2");
  expect_refused(truth, "\n", "\n\n", "line 2");
}

TEST_F(ShortSequence, PicturesOfALongerOneBeforeAreRemoved) {
  const testing::TemporaryDirectory directory;
  write_sequence(*renderer_, directory.path(), {});
  const auto stale = directory / "frames/000005.png";
  write_text(stale, "");
  write_sequence(*renderer_, directory.path(), {});
  EXPECT_FALSE(std::filesystem::exists(stale));
}

TEST_F(ShortSequence, PicturesOfSomebodyElseAreNotTouched) {
  const testing::TemporaryDirectory directory;
  for (const char* name : {"frames/000001.png", "masks/holiday.png", "truth.jsonl"}) {
    const std::filesystem::path folder = directory / std::string(1, name[0]);
    write_text(folder / name, "mine");
    EXPECT_THROW(write_sequence(*renderer_, folder, {}), Error) << name;
    EXPECT_THROW(write_meshes(mesh_frames(*renderer_), folder), Error) << name;
    EXPECT_EQ(read_text(folder / name), "mine");
  }
}

TEST_F(ShortSequence, TheObjectHidesTheShareOfTheHandThatItIsInFrontOf) {
  SequenceSpec palm = short_spec();
  for (Keyframe& key : palm.keyframes)
    key.view = {kPi, 0, 0};  // the object between palm and camera
  const SequenceRenderer from_palm(palm);
  EXPECT_LT(renderer_->render(4).occlusion, 0.1);  // from behind the hand
  EXPECT_GT(from_palm.render(4).occlusion, 0.25);
  palm.object_visible = false;
  EXPECT_EQ(SequenceRenderer(palm).render(4).occlusion, 0);
}

TEST_F(ShortSequence, TheWristMovesByWhatKeyframesAddWithinItsRange) {
  SequenceSpec spec = short_spec();
  spec.keyframes[1].wrist = {radians(20), radians(-90)};
  const SequenceRenderer moved(spec);
  const JointAngles before = renderer_->truth(4).angles, after = moved.truth(4).angles;
  EXPECT_NEAR(degrees(after[kWristFlexion] - before[kWristFlexion]), 20, 1e-9);
  EXPECT_NEAR(degrees(after[kWristDeviation]), -35, 1e-9);
  EXPECT_EQ(after.tail<26>(), before.tail<26>());
  const double half =
      degrees(moved.truth(2).angles[kWristFlexion] - renderer_->truth(2).angles[kWristFlexion]);
  EXPECT_NEAR(half, 10, 1e-9);
}

double mean_level(const SequenceFrame& frame) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < frame.hand.size(); ++i) {
    if (frame.hand.data()[i] == 0) continue;
    sum += frame.color.data()[i][2];
    ++count;
  }
  return sum / count;
}

TEST_F(ShortSequence, LightMovesWithTheKeyframes) {
  SequenceSpec spec = short_spec();
  spec.look.ambient = 0.1;
  spec.keyframes[1].towards_light = {0, 0, 1};  // from behind the hand
  const SequenceRenderer lit(spec);
  EXPECT_LT(mean_level(lit.render(4)), 0.5 * mean_level(lit.render(0)));
}

// How unlike neighbouring pixels are within the hand.
double roughness(const SequenceFrame& frame) {
  double sum = 0, count = 0;
  for (int y = 0; y < frame.hand.height(); ++y) {
    for (int x = 1; x < frame.hand.width(); ++x) {
      if (frame.hand.at(x, y) == 0 || frame.hand.at(x - 1, y) == 0) continue;
      sum += std::abs(int{frame.color.at(x, y)[2]} - int{frame.color.at(x - 1, y)[2]});
      ++count;
    }
  }
  return sum / count;
}

TEST_F(ShortSequence, BlurSmoothsAndMottlingRoughensTheSkin) {
  SequenceSpec spec = short_spec();
  spec.look.sensor_noise = 0;
  const double plain = roughness(SequenceRenderer(spec).render(0));
  spec.look.skin_mottling = 0.2;
  const double mottled = roughness(SequenceRenderer(spec).render(0));
  spec.look.blur_px = 2;
  EXPECT_GT(mottled, 1.1 * plain);
  EXPECT_LT(roughness(SequenceRenderer(spec).render(0)), 0.8 * mottled);
}

TEST(Sequence, AnObjectThatCollidesIsRefused) {
  SequenceSpec spec = short_spec();
  spec.grasp.object =
      make_sphere(0.5);  // no hand closes on half a metre of ball without entering it
  try {
    const SequenceRenderer renderer(spec);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("bottle.seq.toml"));
  }
}

TEST(Sequence, AGraspOfItsTypeTakesThePlaceOfItsOwn) {
  SequenceSpec own = short_spec();
  own.grasp_type = 3;
  const auto known = with_grasp_of_type(own, kSource / "grasps");
  ASSERT_TRUE(known);
  EXPECT_EQ(known->grasp.id, 3);
  EXPECT_NE(known->grasp.object_name, own.grasp.object_name);
  EXPECT_EQ(known->rest, load_rest_pose(kSource / "grasps"));
  EXPECT_NE(known->rest, own.rest);
  EXPECT_EQ(known->keyframes.back().palm, own.keyframes.back().palm);
}

TEST(Sequence, ThereIsNoGraspOfNoTypeOrOfOneThatTheFolderLacks) {
  SequenceSpec spec = short_spec();
  spec.grasp_type = std::nullopt;
  EXPECT_FALSE(with_grasp_of_type(spec, kSource / "grasps"));
  const testing::TemporaryDirectory folder;
  std::filesystem::copy_file(kSource / "grasps/14_tripod.toml", folder / "14_tripod.toml");
  spec.grasp_type = 3;
  EXPECT_FALSE(with_grasp_of_type(spec, folder.path()));
}

TEST(Sequence, BrokenFilesAreNamed) {
  const testing::TemporaryDirectory directory;
  const std::string good = read_text(kSource / "sequences/test/bottle.seq.toml");
  const auto message = [&](const std::string& text) -> std::string {
    write_text(directory / "s.seq.toml", text);
    try {
      load_sequence(directory / "s.seq.toml", kHand);
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  };
  for (const char* file : {"bottle.grasp.toml", "rest.toml"}) {
    std::filesystem::copy_file(kSource / "sequences/test" / file, directory / file);
  }
  EXPECT_EQ(message(good), "no error");
  EXPECT_EQ(message(good + "wrist_deg = [10, -5]\ntowards_light = [0, 0, -1]\n"), "no error");
  EXPECT_THAT(message(good + "wrist_deg = [10]\n"), HasSubstr("wrist_deg"));
  EXPECT_THAT(message("grasp_type = 34\n" + good), HasSubstr("grasp_type"));
  EXPECT_THAT(message("colour = 'red'\n" + good), HasSubstr("colour"));
  EXPECT_THAT(message(good.substr(0, good.find("[[keyframe]]"))), HasSubstr("keyframe"));
}

}  // namespace
}  // namespace graspdb
