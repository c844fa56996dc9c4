// SPDX-License-Identifier: MIT
// One labelled view as a folder of pictures and a view.json (docs/export.md).
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "graspdb/pictures/labelled_view.h"

namespace graspdb {

// What a view shows, as far as it is known.
struct ViewSource {
  std::string hand;
  std::string variant;             // "held" or "free"
  std::optional<int> grasp;        // id
  std::string grasp_name, object;  // empty without a grasp
  std::optional<int> step, steps;
  std::optional<std::size_t> view;
  std::optional<std::size_t> row;  // of a database
  std::string database, content_hash;
};

// Planar z in millimetres, 0 where nothing is hit; at most 65535.
Image<std::uint16_t> depth_in_mm(const Image<float>& meters);

// Writes shading.png, label.png, part.png, depth.png, depth.exr, normal.exr, hand_amodal.png,
// object_amodal.png, each aside and renamed, and last view.json, so that an unfinished folder has
// none. The folder is new, or holds an earlier view and nothing else, which goes. The view has all
// layers. Throws Error.
void write_view(const std::filesystem::path& directory, const LabelledView& view,
                const ViewSource& source);

}  // namespace graspdb
