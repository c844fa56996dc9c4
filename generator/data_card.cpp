// SPDX-License-Identifier: MIT
#include "data_card.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <set>

namespace graspdb {
namespace {

using nlohmann::ordered_json;

constexpr const char* kNotStated = "not stated";

std::string stated(const std::string& text) {
  return text.empty() ? kNotStated : text;
}

ordered_json hands_json(const Plan& plan) {
  ordered_json hands = ordered_json::array();
  for (const Hand& hand : plan.hands) {
    hands.push_back(ordered_json{
        {"name", hand.name}, {"origin", stated(hand.origin)}, {"licence", stated(hand.license)}});
  }
  return hands;
}

// A shape of stated size is nobody's.
ordered_json objects_json(const Plan& plan) {
  ordered_json objects = ordered_json::array();
  for (const Grasp& grasp : plan.grasps) {
    ordered_json object{{"grasp", grasp.id}, {"name", grasp.object_name}};
    if (!grasp.object_file.empty()) {
      object["origin"] = stated(grasp.object_origin);
      object["licence"] = stated(grasp.object_license);
    }
    objects.push_back(std::move(object));
  }
  return objects;
}

// The licences of all that the pictures show; objects in free rows too, for hands close on them.
std::string license(const Plan& plan) {
  std::set<std::string> licenses;
  for (const Hand& hand : plan.hands) licenses.insert(stated(hand.license));
  for (const Grasp& grasp : plan.grasps) {
    if (!grasp.object_file.empty()) licenses.insert(stated(grasp.object_license));
  }
  if (licenses.contains(kNotStated)) {
    return "not stated for every hand and object: ask their authors before you publish it";
  }
  return fmt::format("{}: the terms of its hands and objects; graspdb adds none",
                     fmt::join(licenses, ", "));
}

ordered_json limits() {
  return {"rendered, not photographed: no texture, one skin, one light, no background, no blur",
          "right hands only; a left one is the mirror image of what it sees",
          "each grasp has one object and goes straight from rest to closed",
          "poses are closed on rigid solids by contact, not measured on people",
          "as few hands as are listed here: no variety of people"};
}

}  // namespace

std::string data_card(const Plan& plan) {
  const std::size_t rows = plan.shards().size() * plan.rows_per_shard();
  return ordered_json{
      {"title", "Rendered views of hands that hold objects"},
      {"rows", rows},
      {"row",
       "the pose of a hand (rotation and 28 joint angles) and the descriptor of one view "
       "of it, 512 values; no pictures"},
      {"made_by", "graspdb " GRASPDB_VERSION},
      {"licence", license(plan)},
      {"hands", hands_json(plan)},
      {"objects", objects_json(plan)},
      {"people", "none: nobody was scanned, filmed or recorded for a row"},
      {"use", "estimating hand poses from single pictures and video; research on grasps"},
      {"not_for", ordered_json{"telling people apart", "diagnosis and measuring of real hands",
                               "decisions on which anybody's safety rests"}},
      {"limits", limits()}}
      .dump();
}

}  // namespace graspdb
