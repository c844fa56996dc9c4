// SPDX-License-Identifier: MIT
#include "shards.h"

#include <fmt/format.h>

#include <algorithm>

#include "graspdb/core/error.h"
#include "graspdb/core/hash.h"
#include "graspdb/core/json/json_numbers.h"
#include "jitter.h"

namespace graspdb {

extern const char* const kRowCodeHash;  // written by the build (CMakeLists.txt)

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kKeyDigits = 16;
constexpr std::string_view kExtension = ".graspdb";

// "male-held-003-", "male-held-2-003-", whatever the inputs.
std::string name_of(const Plan& plan, const Shard& shard) {
  std::string name = fmt::format("{}-{}-{:03}-", plan.hands[shard.hand].name,
                                 plan.variants[shard.variant].name(), plan.grasps[shard.grasp].id);
  std::ranges::replace(name, ' ', '-');
  return name;
}

json jitter_of(const Plan& plan, const Shard& shard) {
  const Jitter& jitter = plan.config.jitter;
  if (!jitter.is_on()) return nullptr;
  json inputs = jitter_json(jitter);
  inputs.erase("copies");  // one more leaves the others as they are
  inputs["hand_name"] = plan.hands[shard.hand].name;
  inputs["copy"] = plan.variants[shard.variant].copy;
  return inputs;
}

}  // namespace

std::string shard_inputs(const Plan& plan, const Shard& shard) {
  const BuildConfig& config = plan.config;
  const GraspPose& closed = plan.closed[shard.hand][shard.grasp];
  const DatabaseInfo info = describe_plan(plan);
  return json{{"code", kRowCodeHash},
              {"processor", info.processor},
              {"hand", config.hand_hashes[shard.hand]},
              {"grasp", config.grasp_hashes.at(plan.grasps[shard.grasp].id)},
              {"held", plan.variants[shard.variant].holds},
              {"rest", numbers(plan.rest)},
              {"closed", numbers(closed.angles)},
              {"object_rotation", numbers(closed.hand_from_object.rotation)},
              {"object_translation_m", numbers(closed.hand_from_object.translation)},
              {"steps", config.steps},
              {"views", config.views},
              {"view_rule", info.view_rule},
              {"resolution_px", config.resolution},
              {"distance_m", config.distance},
              {"visible_forearm_m", config.visible_forearm},
              {"renderer", renderer_name(config.renderer)},
              {"ambient", config.light.ambient},
              {"diffuse", config.light.diffuse},
              {"towards_light_in_camera", numbers(config.light.towards_light_in_camera)},
              {"hog", info.hog},
              {"weights", info.weights},
              {"jitter", jitter_of(plan, shard)}}
      .dump();
}

fs::path shard_file(const fs::path& work, const Plan& plan, const Shard& shard) {
  const std::string key = hash_hex(shard_inputs(plan, shard)).substr(0, kKeyDigits);
  return work / (name_of(plan, shard) + key + std::string(kExtension));
}

bool is_finished(const fs::path& shard_file) {
  if (!fs::exists(shard_file)) return false;
  try {
    verify_database(shard_file);
    return true;
  } catch (const Error&) {
    return false;
  }
}

void fail_missing(const fs::path& shard_file) {
  const std::string name = shard_file.filename().string();
  const std::string stem = name.substr(0, name.size() - kKeyDigits - kExtension.size());
  std::string other = "none";
  for (const auto& entry : fs::directory_iterator(shard_file.parent_path())) {
    const std::string candidate = entry.path().filename().string();
    if (candidate.starts_with(stem) && candidate.ends_with(kExtension)) {
      other = candidate + ", made of other files, options or code, or on another processor";
    }
  }
  throw Error({shard_file.parent_path().string(), "", "the shard " + name, other});
}

}  // namespace graspdb
