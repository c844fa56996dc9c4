// SPDX-License-Identifier: MIT
#include "graspdb/samples/sample_config.h"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "graspdb/core/toml.h"
#include "graspdb/grasps/grasp.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;

// One owner of names and ranges: reading and writing go through these.
struct Number {
  const char* key;
  double SampleConfig::*member;
  double low, high;
};
constexpr Number kNumbers[] = {
    {"made_hands", &SampleConfig::made_hands, 0, 1},
    {"held", &SampleConfig::held, 0, 1},
    {"gestures", &SampleConfig::gestures, 0, 1},
    {"mixtures", &SampleConfig::mixtures, 0, 1},
    {"angles_deg", &SampleConfig::angles_deg, 0, 30},
    {"wrist_deg", &SampleConfig::wrist_deg, 0, 45},
    {"object_size_percent", &SampleConfig::object_size_percent, 0, 50},
    {"forearm_mm", &SampleConfig::forearm_mm, 0, 250},
    {"nearest_m", &SampleConfig::nearest_m, 0.35, 5},
    {"farthest_m", &SampleConfig::farthest_m, 0.35, 5},
    {"light", &SampleConfig::light, 0, 1},
    {"skin", &SampleConfig::skin, 0, 2},
    {"sensor", &SampleConfig::sensor, 0, 2},
    {"true_masks", &SampleConfig::true_masks, 0, 1},
    {"occluders", &SampleConfig::occluders, 0, 1},
    {"wrist_cut_mm", &SampleConfig::wrist_cut_mm, 0, 100},
    {"noise_percent", &SampleConfig::noise_percent, 0, 20},
    {"torn", &SampleConfig::torn, 0, 1},
    {"outline_px", &SampleConfig::outline_px, 0, 6},
};
struct Count {
  const char* key;
  int SampleConfig::*member;
  int low, high;
};
constexpr Count kCounts[] = {
    {"seed", &SampleConfig::seed, 0, std::numeric_limits<int>::max()},
    {"views_per_pose", &SampleConfig::views_per_pose, 1, 1000},
    {"poses_per_hand", &SampleConfig::poses_per_hand, 1, 100000},
    {"smallest_px", &SampleConfig::smallest_px, 32, 512},
    {"largest_px", &SampleConfig::largest_px, 32, 512},
};

void check_order(const TomlTable& table, const SampleConfig& config) {
  if (config.nearest_m > config.farthest_m) {
    table.fail("nearest_m", "no more than farthest_m", fmt::format("{}", config.nearest_m));
  }
  if (config.smallest_px > config.largest_px) {
    table.fail("smallest_px", "no more than largest_px", fmt::format("{}", config.smallest_px));
  }
  if (config.gestures + config.mixtures > 1) {
    table.fail("mixtures", "at most 1 together with gestures", fmt::format("{}", config.mixtures));
  }
}

}  // namespace

SampleConfig load_sample_config(const fs::path& file) {
  const TomlTable table = TomlTable::load(file);
  const fs::path beside = file.parent_path();
  SampleConfig config;
  if (table.has("hands")) {
    for (const auto& hand : table.strings("hands")) {
      config.hands.push_back(table.found("hands", hand, beside));
    }
  }
  if (table.has("grasps")) config.grasps = table.found("grasps", table.string("grasps"), beside);
  if (table.has("leave_out")) config.leave_out = table.integers("leave_out", 1, kLargestGrasp);
  for (const auto& [key, member, low, high] : kNumbers) {
    config.*member = table.number_or(key, config.*member, low, high);
  }
  for (const auto& [key, member, low, high] : kCounts) {
    config.*member = table.integer_or(key, config.*member, low, high);
  }
  check_order(table, config);
  table.finish();
  return config;
}

std::string sample_config_json(const SampleConfig& config) {
  nlohmann::ordered_json json;
  json["hands"] = nlohmann::ordered_json::array();
  for (const fs::path& hand : config.hands) json["hands"].push_back(hand.stem().string());
  json["leave_out"] = config.leave_out;
  for (const Count& count : kCounts) json[count.key] = config.*count.member;
  for (const Number& number : kNumbers) json[number.key] = config.*number.member;
  return json.dump();
}

}  // namespace graspdb
