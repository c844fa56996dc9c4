// SPDX-License-Identifier: MIT
#include "graspdb/pictures/row_sheet.h"

#include <fmt/format.h>

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "graspdb/core/error.h"
#include "graspdb/core/opencv/opencv_image.h"
#include "graspdb/core/parallel.h"
#include "graspdb/pictures/database_rows.h"
#include "model_view.h"

namespace graspdb {
namespace {

constexpr int kRowTile = 144;  // pixels
constexpr int kGap = 10;
constexpr int kCaption = 30;
constexpr int kTitle = 26;

using Mat = cv::Mat_<cv::Vec3b>;

Mat row_picture(ColorImage picture) {
  Mat scaled;
  const int method = picture.width() < kRowTile ? cv::INTER_LINEAR : cv::INTER_AREA;
  cv::resize(as_mat(picture), scaled, {kRowTile, kRowTile}, 0, 0, method);
  return scaled;
}

struct Tile {
  Mat picture;
  std::string upper, lower;  // below the picture
};

Tile row_tile(const Database& database, const DatabaseRows& rows, std::size_t row) {
  const LabelledView view = rows.view(rows.subject(row), row, {});
  return {row_picture(colored(view.picture)),
          fmt::format("grasp {} step {} view {}", database.grasp(row), database.step(row),
                      database.view(row)),
          fmt::format("row {} {}", row, database.info().variants[database.variant(row)])};
}

// As wide as a screen is.
std::size_t columns_for(std::size_t tiles) {
  return std::max<std::size_t>(
      4, static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(tiles) * 1.8))));
}

ColorImage draw_page(const std::vector<Tile>& tiles, const std::string& title) {
  const std::size_t columns = columns_for(tiles.size());
  const std::size_t lines = (tiles.size() + columns - 1) / columns;
  Page page(static_cast<int>(columns) * (kRowTile + kGap),
            kTitle + static_cast<int>(lines) * (kRowTile + kCaption));
  page.write(title, 6, 18);
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const int x = static_cast<int>(i % columns) * (kRowTile + kGap);
    const int y = kTitle + static_cast<int>(i / columns) * (kRowTile + kCaption);
    page.place(tiles[i].picture, x, y);
    page.write_small(tiles[i].upper, x + 6, y + kRowTile + 11);
    page.write_small(tiles[i].lower, x + 6, y + kRowTile + 24);
  }
  return page.image();
}

}  // namespace

ColorImage draw_row_sheet(const Database& database, std::span<const std::size_t> chosen,
                          const std::string& title, const ColorImage& first) {
  if (chosen.empty()) {
    throw Error({.file = database.path().string(), .expected = "rows to show", .found = "none"});
  }
  const DatabaseRows rows(database, chosen);
  const std::size_t before = first.empty() ? 0 : 1;
  std::vector<Tile> tiles(before + chosen.size());
  if (before > 0) tiles[0] = {row_picture(first), "the picture", "its nearest rows follow"};
  parallel_for(chosen.size(), 0,
               [&](std::size_t i) { tiles[before + i] = row_tile(database, rows, chosen[i]); });
  return draw_page(tiles, title);
}

}  // namespace graspdb
