// SPDX-License-Identifier: MIT
#include "plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "graspdb/error.h"
#include "graspdb/file.h"
#include "graspdb/hash.h"
#include "graspdb/parallel.h"
#include "graspdb/posed_scene.h"
#include "graspdb/rig.h"
#include "graspdb/views.h"

namespace graspdb {
namespace {

std::vector<Grasp> choose(std::vector<Grasp> grasps, const std::vector<int>& only,
                          const std::filesystem::path& directory) {
  if (only.empty()) return grasps;
  std::vector<Grasp> chosen;
  for (int id : only) {
    const auto found =
        std::find_if(grasps.begin(), grasps.end(), [id](const Grasp& g) { return g.id == id; });
    if (found == grasps.end()) {
      throw Error({directory.string(), "id", fmt::format("a grasp {}", id), "none"});
    }
    const auto same = [id](const Grasp& g) { return g.id == id; };
    if (std::any_of(chosen.begin(), chosen.end(), same)) {
      throw Error(
          {.key = "only", .expected = "each grasp once", .found = fmt::format("{} twice", id)});
    }
    chosen.push_back(*found);
  }
  return chosen;
}

std::vector<bool> variants_of(Objects objects) {
  switch (objects) {
    case Objects::kHeld:
      return {true};
    case Objects::kFree:
      return {false};
    case Objects::kBoth:
      return {true, false};
  }
  GRASPDB_CHECK(false);
  return {};
}

// The renderer chooses its instructions by the processor; other ones may round differently.
std::string processor_kind() {
  if (__builtin_cpu_supports("avx512bw")) return "x86-64 avx512";
  if (__builtin_cpu_supports("avx2")) return "x86-64 avx2";
  return "x86-64";
}

void check_range(const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return;
  throw Error({.key = name,
               .expected = fmt::format("{} to {}", low, high),
               .found = fmt::format("{}", value)});
}

void check_config(const BuildConfig& config) {
  check_range("steps", config.steps, 1, 20);
  check_range("views", config.views, 1, 100000);
  check_range("resolution", config.resolution, 16, 1024);
  check_range("distance", config.distance, 0.2, 5);
  check_range("visible forearm", config.visible_forearm, 0, 0.3);
}

// What the rows depend on beside what DatabaseInfo holds in fields of its own.
nlohmann::json config_json(const Plan& plan) {
  nlohmann::json hands = nlohmann::json::array(), grasps = nlohmann::json::object();
  for (const auto& file : plan.config.hands) hands.push_back(hash_hex(read_text(file)));
  for (const Grasp& grasp : plan.grasps) grasps[std::to_string(grasp.id)] = grasp_hash(grasp);
  const Light& light = plan.config.light;
  const Eigen::Vector3d& towards = light.towards_light_in_camera;
  return {{"resolution_px", plan.config.resolution},
          {"visible_forearm_m", plan.config.visible_forearm},
          {"light",
           {{"ambient", light.ambient},
            {"diffuse", light.diffuse},
            {"towards_light_in_camera", {towards.x(), towards.y(), towards.z()}}}},
          {"hand_hashes", std::move(hands)},
          {"grasp_hashes", std::move(grasps)}};
}

}  // namespace

Plan make_plan(const BuildConfig& config) {
  check_config(config);
  Plan plan{.config = config};
  plan.grasps = choose(load_grasps(config.grasps), config.only, config.grasps);
  plan.rest = load_rest_pose(config.grasps);
  for (const auto& file : config.hands) {
    const Hand hand = load_hand(file);
    std::vector<GraspPose>& closed = plan.closed.emplace_back(plan.grasps.size());
    parallel_for(closed.size(), config.threads,
                 [&](std::size_t i) { closed[i] = closed_pose(plan.grasps[i], hand); });
    plan.hands.push_back(with_visible_forearm(hand, config.visible_forearm));
  }
  plan.variant_holds = variants_of(config.objects);
  plan.views = view_rotations(config.views);
  return plan;
}

std::size_t Plan::pose_count() const {
  return hands.size() * variant_holds.size() * grasps.size() *
         static_cast<std::size_t>(config.steps);
}

Plan::Pose Plan::pose(std::size_t index) const {
  const auto steps = static_cast<std::size_t>(config.steps);
  const int step = static_cast<int>(index % steps) + 1;
  index /= steps;
  const std::size_t grasp = index % grasps.size();
  index /= grasps.size();
  return {index / variant_holds.size(), index % variant_holds.size(), grasp, step};
}

DatabaseInfo describe_plan(const Plan& plan) {
  DatabaseInfo info;
  for (const Grasp& grasp : plan.grasps) info.grasps.push_back({grasp.id, grasp.name});
  for (const Hand& hand : plan.hands) info.hands.push_back({hand.name, hand.skeleton});
  for (bool holds : plan.variant_holds) info.variants.emplace_back(holds ? "held" : "free");
  info.steps = plan.config.steps;
  info.views = plan.config.views;
  info.camera_distance = plan.config.distance;
  info.view_rule = "super-fibonacci";
  info.hog = hog_name(plan.config.hog);
  info.tool = "graspdb " GRASPDB_VERSION;
  info.processor = processor_kind();
  info.config = config_json(plan).dump();
  return info;
}

}  // namespace graspdb
