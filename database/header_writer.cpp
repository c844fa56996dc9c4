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
  const Columns all = columns_of(info);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string name(all[i].name);
    columns[name] = column_description(all[i], static_cast<ColumnIndex>(i));
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
                        {"format_version", version_of(info)},
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
  if (info.embedding_bytes > 0) {
    metadata["descriptor"] = info.descriptor;
    metadata["weights_hash"] = info.weights;
  }
  if (!info.data_card.empty()) metadata["data_card"] = info.data_card;
  return metadata;
}

ordered_json header_json(const Header& header) {
  ordered_json root{{"__metadata__", metadata_json(header)}};
  const Columns columns = columns_of(header.info);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    root[std::string(columns[i].name)] = ordered_json::parse(columns.json(i, header.rows));
  }
  return root;
}

}  // namespace

std::string content_hash(const ColumnHashes& hashes) {
  return hash_hex(fmt::format("{}", fmt::join(hashes, "")));
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
