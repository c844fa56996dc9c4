// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "graspdb/core/error.h"
#include "graspdb/core/hash.h"
#include "header.h"

namespace graspdb {
namespace {

using nlohmann::ordered_json;

ordered_json column_description(const Column& column, ColumnIndex index) {
  ordered_json description{{"unit", column.unit}};
  if (index == kBox) description["names"] = {"x", "y", "width", "height"};
  if (index != kLabel) return description;
  ordered_json names{"camera_from_hand_x", "camera_from_hand_y", "camera_from_hand_z"};
  for (int angle = 0; angle < kAngleCount; ++angle) names.push_back(angle_info(angle).name);
  description["names"] = std::move(names);
  return description;
}

ordered_json metadata_json(const Header& header) {
  const DatabaseInfo& info = header.info;
  ordered_json columns, hashes, grasps = ordered_json::array(), hands = ordered_json::array();
  for (std::size_t i = 0; i < kColumns.size(); ++i) {
    const std::string name(kColumns[i].name);
    columns[name] = column_description(kColumns[i], static_cast<ColumnIndex>(i));
    hashes[name] = header.column_hashes[i];
  }
  for (const GraspEntry& grasp : info.grasps) {
    grasps.push_back(ordered_json{{"id", grasp.id}, {"name", grasp.name}});
  }
  for (const HandEntry& hand : info.hands) {
    hands.push_back(ordered_json{
        {"name", hand.name}, {"skeleton", ordered_json::parse(skeleton_to_json(hand.skeleton))}});
  }
  ordered_json metadata{{"format", "graspdb"},
                        {"format_version", kVersion},
                        {"header_hash", std::string(kHashDigits, '0')},
                        {"content_hash", content_hash(header.column_hashes)},
                        {"column_hashes", hashes.dump()},
                        {"columns", columns.dump()},
                        {"grasps", grasps.dump()},
                        {"hands", hands.dump()},
                        {"variants", ordered_json(info.variants).dump()},
                        {"steps", std::to_string(info.steps)},
                        {"views", std::to_string(info.views)},
                        {"camera_distance_m", ordered_json(info.camera_distance).dump()},
                        {"view_rule", info.view_rule},
                        {"hog", info.hog},
                        {"config", info.config},
                        {"config_hash", hash_hex(info.config)},
                        {"tool", info.tool},
                        {"processor", info.processor}};
  if (!info.data_card.empty()) metadata["data_card"] = info.data_card;
  return metadata;
}

ordered_json header_json(const Header& header) {
  ordered_json root{{"__metadata__", metadata_json(header)}};
  for (std::size_t i = 0; i < kColumns.size(); ++i) {
    root[std::string(kColumns[i].name)] = ordered_json::parse(column_json(i, header.rows));
  }
  return root;
}

}  // namespace

std::string content_hash(const ColumnHashes& hashes) {
  return hash_hex(fmt::format("{}", fmt::join(hashes, "")));
}

std::string column_json(std::size_t column, std::size_t rows) {
  const auto& [name, dtype, item_bytes, width, unit] = kColumns[column];
  const std::string shape =
      width == 0 ? fmt::format("[{}]", rows) : fmt::format("[{},{}]", rows, width);
  return fmt::format(R"({{"dtype":"{}","shape":{},"data_offsets":[{},{}]}})", dtype, shape,
                     column_offset(column, rows), column_offset(column + 1, rows));
}

std::string header_bytes(const Header& header, const std::string& file) {
  std::string text;
  try {
    text = header_json(header).dump();
  } catch (const ordered_json::exception& fault) {  // a name that is not UTF-8
    throw Error({.file = file, .key = "header", .expected = "UTF-8", .found = fault.what()});
  }
  const std::size_t used = (kPrefixBytes + text.size()) % kAlignment;
  text.append(used == 0 ? 0 : kAlignment - used, ' ');
  text.replace(kHashPosition, kHashDigits, hash_hex(text));
  const std::uint64_t length = text.size();
  return std::string(reinterpret_cast<const char*>(&length), kPrefixBytes) + text;
}

}  // namespace graspdb
