// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <algorithm>

#include "graspdb/renderer/image_io.h"
#include "program.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using ::testing::HasSubstr;
using testing::run_program;

const std::string kHand = GRASPDB_SOURCE_DIR "/assets/hands/child.glb";

// How many pixels of a square of a page are not white.
int drawn(const GrayImage& page, int left, int top, int side) {
  int count = 0;
  for (int y = top; y < top + side; ++y) {
    for (int x = left; x < left + side; ++x) count += page.at(x, y) < 240 ? 1 : 0;
  }
  return count;
}

class HandSheet : public ::testing::Test {
 protected:
  GrayImage sheet(const std::string& options) {
    const std::string file = (directory_ / "sheet.png").string();
    const auto outcome = run_program("hand sheet " + kHand + " --out " + file + options);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return read_gray(file);
  }
  testing::TemporaryDirectory directory_;
};

TEST_F(HandSheet, ShowsFivePosesFromFourSides) {
  const GrayImage page = sheet("");
  const int tile = page.width() / 4, row = page.height() / 5;
  for (int i = 0; i < 20; ++i) {
    EXPECT_GT(drawn(page, i % 4 * tile, i / 4 * row + row - tile, tile), tile * tile / 20) << i;
  }
}

TEST_F(HandSheet, ShowsEachAngleTwice) {
  const GrayImage page = sheet(" --angles");
  const int width = page.width() / 4, row = page.height() / 7, tile = (width - 10) / 2;
  for (int angle = 0; angle < 28; ++angle) {
    const int left = angle % 4 * width, top = angle / 4 * row + row - tile;
    EXPECT_GT(drawn(page, left, top, tile), tile * tile / 20) << angle;
    int different = 0;
    for (int y = top; y < top + tile; ++y) {
      for (int x = left; x < left + tile; ++x) {
        different += std::abs(page.at(x, y) - page.at(x + tile, y)) > 8 ? 1 : 0;
      }
    }
    EXPECT_GT(different, 20) << angle;
  }
}

TEST_F(HandSheet, AForeignRigMapIsNamedWhenItDoesNotFit) {
  const auto outcome = run_program("hand sheet " + kHand + " --rig /nowhere.toml --out " +
                                   (directory_ / "x.png").string());
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("/nowhere.toml"));
}

}  // namespace
}  // namespace graspdb
