// SPDX-License-Identifier: MIT
#include "plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/hash.h"
#include "graspdb/core/parallel.h"
#include "graspdb/generator/views.h"
#include "graspdb/hand/rig/rig.h"

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

// Rows and shards tell hands by their names: the stems of their files.
void check_names(const std::vector<std::filesystem::path>& hands) {
  std::set<std::string> names;
  for (const auto& file : hands) {
    const std::string name = file.stem().string();
    if (names.insert(name).second) continue;
    throw Error({.file = file.string(),
                 .key = "hands",
                 .expected = "another name for each hand",
                 .found = name + " twice"});
  }
}

std::vector<Variant> variants_of(const BuildConfig& config) {
  std::vector<Variant> variants;
  for (int copy = 1; copy <= config.jitter.copies; ++copy) {
    if (config.objects != Objects::kFree) variants.push_back({.holds = true, .copy = copy});
    if (config.objects != Objects::kHeld) variants.push_back({.holds = false, .copy = copy});
  }
  return variants;
}

// The renderer chooses its instructions by the processor; other ones may round differently.
std::string processor_kind() {
  if (__builtin_cpu_supports("avx512bw")) return "x86-64 avx512";
  if (__builtin_cpu_supports("avx2")) return "x86-64 avx2";
  return "x86-64";
}

std::string hand_hash(const std::filesystem::path& file) {
  const std::string hand = read_text(file);  // first: without a hand nobody misses its map
  return hash_hex(hand + read_text(rig_map_beside(file)));
}

void expect_hash(const std::filesystem::path& file, const std::string& expected,
                 const std::string& found) {
  if (expected == found) return;
  throw Error({file.string(), "", "the file of the configuration, hash " + expected, found});
}

// Fills in what the files are, or refuses those that are not what the configuration says.
void settle_hashes(const std::vector<Grasp>& grasps, BuildConfig& config) {
  std::vector<std::string> hands;
  for (const auto& file : config.hands) hands.push_back(hand_hash(file));
  for (std::size_t i = 0; i < std::min(hands.size(), config.hand_hashes.size()); ++i) {
    expect_hash(config.hands[i], config.hand_hashes[i], hands[i]);
  }
  std::map<int, std::string> hashes;
  for (const Grasp& grasp : grasps) {
    hashes[grasp.id] = grasp_hash(grasp);
    const auto known = config.grasp_hashes.find(grasp.id);
    if (known != config.grasp_hashes.end()) {
      expect_hash(grasp.file, known->second, hashes[grasp.id]);
    }
  }
  config.hand_hashes = std::move(hands);
  config.grasp_hashes = std::move(hashes);
}

std::shared_ptr<const EmbeddingNet> load_net(BuildConfig& config) {
  auto net = std::make_shared<const EmbeddingNet>(EmbeddingNet::load(config.descriptor));
  if (!config.descriptor_hash.empty()) {
    expect_hash(config.descriptor, config.descriptor_hash, net->hash());
  }
  config.descriptor_hash = net->hash();
  return net;
}

}  // namespace

std::string Variant::name() const {
  const std::string kind = holds ? "held" : "free";
  return copy == 1 ? kind : fmt::format("{} {}", kind, copy);
}

Plan make_plan(const BuildConfig& config, int threads) {
  check_config(config);
  check_names(config.hands);
  Plan plan{.config = config};
  plan.grasps = choose(load_grasps(config.grasps), config.only, config.grasps);
  settle_hashes(plan.grasps, plan.config);
  plan.rest = load_rest_pose(config.grasps);
  for (const auto& file : config.hands) {
    const Hand& hand = plan.hands.emplace_back(load_hand(file));
    std::vector<GraspPose>& closed = plan.closed.emplace_back(plan.grasps.size());
    parallel_for(closed.size(), threads,
                 [&](std::size_t i) { closed[i] = closed_pose(plan.grasps[i], hand); });
  }
  if (!config.descriptor.empty()) plan.net = load_net(plan.config);
  plan.variants = variants_of(config);
  plan.views = view_rotations(config.views);
  return plan;
}

std::vector<Shard> Plan::shards() const {
  std::vector<Shard> all;
  for (std::size_t hand = 0; hand < hands.size(); ++hand) {
    for (std::size_t variant = 0; variant < variants.size(); ++variant) {
      for (std::size_t grasp = 0; grasp < grasps.size(); ++grasp) {
        all.push_back({hand, variant, grasp});
      }
    }
  }
  return all;
}

DatabaseInfo describe_plan(const Plan& plan) {
  DatabaseInfo info;
  for (const Grasp& grasp : plan.grasps) info.grasps.push_back({grasp.id, grasp.name});
  for (const Hand& hand : plan.hands) info.hands.push_back({hand.name, hand.skeleton});
  for (const Variant& variant : plan.variants) info.variants.push_back(variant.name());
  info.steps = plan.config.steps;
  info.views = plan.config.views;
  info.camera_distance = plan.config.distance;
  info.view_rule = kViewRule;
  info.hog = hog_name(plan.config.hog);
  if (plan.net) {
    info.descriptor = plan.config.descriptor.stem().string();
    info.weights = plan.net->hash();
    info.embedding_bytes = plan.net->size();
  }
  info.tool = "graspdb " GRASPDB_VERSION;
  info.processor = processor_kind();
  info.config = config_to_json(plan.config);
  return info;
}

DatabaseInfo describe_shard(const Plan& plan, const Shard& shard) {
  DatabaseInfo info = describe_plan(plan);
  info.grasps = {info.grasps[shard.grasp]};
  info.hands = {info.hands[shard.hand]};
  info.variants = {info.variants[shard.variant]};
  return info;
}

}  // namespace graspdb
