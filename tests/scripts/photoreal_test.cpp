// SPDX-License-Identifier: MIT
// The hand in photoreal frames is the hand of the sequence, seen by the same camera.
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
    write_meshes(renderer, folder_ / "meshes");
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

}  // namespace
}  // namespace graspdb
