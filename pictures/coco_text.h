// SPDX-License-Identifier: MIT
// The parts of COCO's annotations.json, each as compact JSON.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "graspdb/database/database.h"
#include "graspdb/pictures/labelled_view.h"

namespace graspdb {

// COCO's uncompressed run lengths of the pixels with this value: down the columns, from left to
// right, first those without it (perhaps 0), then those with it, and so on.
std::vector<std::uint32_t> run_lengths(const Image<std::uint8_t>& image, std::uint8_t value);

// "info":{...},"licenses":[...],"categories":[...]
std::string coco_head(const Database& database);

std::string coco_image(std::size_t row, int width, int height);

// None when no pixel of the hand is visible: there is nothing to find.
std::optional<std::string> coco_annotation(const Database& database, std::size_t row,
                                           const LabelledView& view);

// The row as twelve digits, and ".png".
std::string coco_file_name(std::size_t row);

}  // namespace graspdb
