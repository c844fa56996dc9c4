// SPDX-License-Identifier: MIT
// The hand in photoreal frames is the hand of the sequence, seen by the same camera.
#include <OpenImageIO/imagebuf.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "blender.h"
#include "graspdb/core/file.h"
#include "graspdb/renderer/image_io.h"
#include "graspdb/sequences/sequence.h"
#include "support/source_folder.h"
#include "support/temporary_directory.h"
#include "support/tripod_sequence.h"

namespace graspdb {
namespace {

using testing::kSource;

bool has_opencv() {
  return std::system("/usr/bin/python3 -c 'import cv2' 2>/dev/null") == 0;
}

// The principal point is not in the middle; the name is one that there is a look for.
SequenceSpec two_frames() {
  SequenceSpec spec = testing::tripod_sequence();
  spec.name = "jar";
  spec.camera.cx = 170;
  spec.camera.cy = 105;
  spec.keyframes.back().time = 0.1;
  return spec;
}

class Photoreal : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!testing::has_blender()) GTEST_SKIP() << testing::kNoBlender;
    if (!has_opencv()) GTEST_SKIP() << "no cv2 for Blender's Python (Debian: python3-opencv)";
    const SequenceRenderer renderer(two_frames());
    write_meshes(mesh_frames(renderer), folder_ / "meshes");
    write_sequence(renderer, folder_ / "seq", {});
  }

  testing::BlenderOutcome run(std::vector<std::string> options) const {
    std::vector<std::string> arguments = {
        folder("meshes"), kSource / "scripts/blender/photoreal.toml", "train", folder("photos")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return testing::run_blender("", "scripts/blender/photoreal.py", arguments);
  }
  std::string folder(const std::string& name) const { return (folder_ / name).string(); }

  testing::TemporaryDirectory folder_;
};

TEST_F(Photoreal, SilhouettesAreThoseOfTheTrueMasks) {
  const testing::BlenderOutcome right = run({"--check", folder("seq/masks"), "--frames", "0,1"});
  EXPECT_EQ(right.code, 0) << right.output;

  // Two pixels beside the truth are too many.
  const std::filesystem::path file = folder_ / "seq/masks/000001.png";
  const Mask mask = read_gray(file);
  Mask moved(mask.width(), mask.height());
  for (int y = 0; y < mask.height(); ++y)
    std::copy(mask.row(y), mask.row(y) + mask.width() - 2, moved.row(y) + 2);
  write_png(file, moved);
  EXPECT_NE(run({"--check", folder("seq/masks"), "--frames", "1"}).code, 0);
}

TEST_F(Photoreal, FramesThatAreMissingAreRendered) {
  std::filesystem::create_directories(folder("photos"));
  write_text(folder_ / "photos/000001.jpg", "is there");
  const testing::BlenderOutcome outcome = run({});
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  EXPECT_EQ(read_text(folder_ / "photos/000001.jpg"), "is there");
  const ColorImage photo = read_color(folder_ / "photos/000000.jpg");
  EXPECT_EQ(photo.width(), 320);
  EXPECT_EQ(photo.height(), 240);
}

constexpr int kSleeve = 4;  // a label

// Two frames as `graspdb scenes` writes them.
class PhotorealScenes : public Photoreal {
 protected:
  void SetUp() override {
    Photoreal::SetUp();
    if (IsSkipped()) return;
    const SequenceRenderer renderer(two_frames());
    const MeshFrames scene = mesh_frames(renderer);
    write_meshes(scene, folder_ / "scenes/000007");
    for (std::size_t i = 0; i < 2; ++i) labels_.push_back(frame_labels(scene, i));
  }

  testing::BlenderOutcome render() const {
    return testing::run_blender(
        "", "scripts/blender/photoreal_scenes.py",
        {folder("scenes"), kSource / "scripts/blender/photoreal.toml", folder("out")});
  }

  std::vector<float> alphas_of(const std::string& name) const {
    const OIIO::ImageBuf image((folder_ / name).string());
    const OIIO::ROI alpha(0, image.spec().width, 0, image.spec().height, 0, 1, 3, 4);
    std::vector<float> values(static_cast<std::size_t>(alpha.npixels()));
    EXPECT_TRUE(image.get_pixels(alpha, OIIO::TypeDesc::FLOAT, values.data()));
    return values;
  }

  std::vector<Image<std::uint8_t>> labels_;
};

TEST_F(PhotorealScenes, EveryFrameHasAPhotographWithLabels) {
  const testing::BlenderOutcome outcome = render();
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string number = std::to_string(i);
    const ColorImage photo = read_color(folder_ / ("out/000007/photo" + number + ".jpg"));
    EXPECT_EQ(photo.width(), 320);
    const Levels labels = read_levels(folder_ / ("out/000007/labels" + number + ".png"));
    const std::vector<float> alphas = alphas_of("out/000007/front" + number + ".png");
    ASSERT_EQ(alphas.size(), photo.size());
    std::size_t sleeve = 0, seen = 0, solid = 0;
    for (std::size_t p = 0; p < photo.size(); ++p) {
      const int label = labels.gray.data()[p], drawn = labels_[i].data()[p];
      EXPECT_TRUE(label == drawn || label == kSleeve) << label << " at " << p;
      sleeve += label == kSleeve;
      seen += label != 0;
      solid += label != 0 && alphas[p] > 0.99F;
    }
    EXPECT_GT(sleeve, 100u);
    EXPECT_GT(solid, seen * 9 / 10);  // all but outlines
  }
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/000007/room.png"));
}

TEST_F(PhotorealScenes, ScenesThatAreThereAreKept) {
  std::filesystem::create_directories(folder("out/000007"));
  ASSERT_EQ(render().code, 0);
  EXPECT_TRUE(std::filesystem::is_empty(folder("out/000007")));
}

}  // namespace
}  // namespace graspdb
