// SPDX-License-Identifier: MIT
#include "row_sheet.h"

#include <fmt/format.h>

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "graspdb/database_rows.h"
#include "graspdb/error.h"
#include "graspdb/parallel.h"
#include "model_view.h"
#include "row_selection.h"

namespace graspdb::cli {
namespace {

constexpr int kTile = 144;  // pixels
constexpr int kGap = 10;
constexpr int kCaption = 30;
constexpr int kTitle = 26;

using Mat = cv::Mat_<cv::Vec3b>;

Mat tile(const DatabaseRows& rows, std::size_t row) {
  const LabelledView view = rows.view(rows.subject(row), row, {});
  ColorImage picture = coloured(view.picture);
  Mat scaled;
  const int method = picture.width() < kTile ? cv::INTER_LINEAR : cv::INTER_AREA;
  cv::resize(as_mat(picture), scaled, {kTile, kTile}, 0, 0, method);
  return scaled;
}

// As wide as a screen is.
std::size_t columns_for(std::size_t tiles) {
  return std::max<std::size_t>(
      4, static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(tiles) * 1.8))));
}

}  // namespace

ColorImage draw_row_sheet(const Database& database, std::size_t count) {
  const std::vector<std::size_t> chosen = spread_rows(database.rows(), count);
  if (chosen.empty()) {
    throw Error({.file = database.path().string(), .expected = "rows to show", .found = "none"});
  }
  const DatabaseRows rows(database, chosen);
  std::vector<Mat> tiles(chosen.size());
  parallel_for(tiles.size(), 0, [&](std::size_t i) { tiles[i] = tile(rows, chosen[i]); });
  const std::size_t columns = columns_for(tiles.size());
  const std::size_t lines = (tiles.size() + columns - 1) / columns;
  Page page(static_cast<int>(columns) * (kTile + kGap),
            kTitle + static_cast<int>(lines) * (kTile + kCaption));
  page.write(fmt::format("{}: {} of {} rows", database.path().filename().string(), tiles.size(),
                         database.rows()),
             6, 18);
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const std::size_t row = chosen[i];
    const int x = static_cast<int>(i % columns) * (kTile + kGap);
    const int y = kTitle + static_cast<int>(i / columns) * (kTile + kCaption);
    page.place(tiles[i], x, y);
    page.write_small(fmt::format("grasp {} step {} view {}", database.grasp(row),
                                 database.step(row), database.view(row)),
                     x + 6, y + kTile + 11);
    page.write_small(fmt::format("row {} {}", row, database.info().variants[database.variant(row)]),
                     x + 6, y + kTile + 24);
  }
  return page.image();
}

}  // namespace graspdb::cli
