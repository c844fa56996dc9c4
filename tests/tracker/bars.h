// SPDX-License-Identifier: MIT
// A database of bars instead of hands, so that right answers are plain.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "graspdb/core/camera.h"
#include "graspdb/core/transform.h"
#include "graspdb/database/database.h"
#include "graspdb/database/search.h"
#include "graspdb/features/hog.h"
#include "support/temporary_directory.h"
#include "support/toy_skeleton.h"

namespace graspdb::testing {

inline constexpr int kSide = 96;
inline constexpr Intrinsics kCamera{.width = kSide,
                                    .height = kSide,
                                    .fx = 480,
                                    .fy = 480,
                                    .cx = (kSide - 1) / 2.0,
                                    .cy = (kSide - 1) / 2.0};

struct BarPicture {
  GrayImage gray{kSide, kSide};
  Mask mask{kSide, kSide};
};

// A bright bar that lies at this angle to the picture's x axis.
inline BarPicture bar(double angle, double half_length = 36, double half_breadth = 12) {
  BarPicture picture;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const double u = x - kSide / 2.0, v = y - kSide / 2.0;
      const double along = u * std::cos(angle) + v * std::sin(angle);
      const double across = -u * std::sin(angle) + v * std::cos(angle);
      if (std::abs(along) > half_length || std::abs(across) > half_breadth) continue;
      picture.mask.at(x, y) = 255;
      picture.gray.at(x, y) = static_cast<std::uint8_t>(150 + 2 * across);
    }
  }
  return picture;
}

// Rows 0 to 7 are bars turned by 20 degrees from row to row, the hand turned with them. Row 8 looks
// as row 2 does but is turned the other way round; rows 9 and 10 look like nothing else and have
// the poses of rows 2 and 8.
class BarDatabase : public ::testing::Test {
 protected:
  static constexpr std::size_t kBars = 8, kFlipped = 2;
  static double angle_of(std::size_t row) { return radians(20.0 * static_cast<double>(row)); }
  static BarPicture square() { return bar(0, 20, 20); }
  static BarPicture thin() { return bar(radians(90), 40, 5); }

  static Row row(const BarPicture& picture, double angle, int grasp) {
    Row row;
    row.hog = describe(picture.gray, picture.mask, HogMode::kPaper);
    row.label[2] = static_cast<float>(angle);
    const Box box = tight_box(picture.mask).value();
    row.box = {static_cast<float>((box.x - 0.5 - kCamera.cx) / kCamera.fx),
               static_cast<float>((box.y - 0.5 - kCamera.cy) / kCamera.fy),
               static_cast<float>(box.width / kCamera.fx),
               static_cast<float>(box.height / kCamera.fy)};
    row.grasp = static_cast<std::uint16_t>(grasp);
    row.step = 1;
    return row;
  }

  BarDatabase() {
    const DatabaseInfo info{.grasps = {{1, "one"}, {2, "two"}},
                            .hands = {{"toy", toy_skeleton()}},
                            .variants = {"free"},
                            .steps = 1,
                            .views = 4,
                            .camera_distance = 0.7,
                            .view_rule = "bars",
                            .hog = hog_name(HogMode::kPaper),
                            .config = "{}",
                            .tool = "test"};
    std::vector<Row> rows;
    for (std::size_t i = 0; i < kBars; ++i)
      rows.push_back(row(bar(angle_of(i)), angle_of(i), i < 4 ? 1 : 2));
    const double turned = angle_of(kFlipped) - kPi;
    rows.push_back(row(bar(angle_of(kFlipped)), turned, 2));
    rows.push_back(row(square(), angle_of(kFlipped), 1));
    rows.push_back(row(thin(), turned, 2));
    rows.push_back(row(bar(radians(70), 20, 6), turned, 2));  // makes the last pose whole
    write_database(directory_ / "bars.graspdb", info, rows);
    database_.emplace(Database::open(directory_ / "bars.graspdb"));
    search_ = make_exact_search(*database_);
  }

  TemporaryDirectory directory_;
  std::optional<Database> database_;
  std::unique_ptr<Search> search_;
};

}  // namespace graspdb::testing
