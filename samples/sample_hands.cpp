// SPDX-License-Identifier: MIT
#include "sample_hands.h"

#include <algorithm>
#include <cmath>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/hash.h"
#include "graspdb/core/parallel.h"
#include "graspdb/hand/maker/hand_maker.h"
#include "graspdb/hand/rig/rig.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;

// Made hands took nearly half of the time, and a picture's pixels are larger than their triangles.
constexpr double kCoarseness = 1.5;
constexpr int kMostShapes = 20;  // of measures; one in ten is out of proportion

std::vector<fs::path> default_hands() {
  std::vector<fs::path> files;
  for (const std::string& name : kDefaultHands) files.push_back(default_hand_file(name));
  return files;
}

std::vector<Grasp> chosen_grasps(const SampleConfig& config, const fs::path& folder) {
  std::vector<Grasp> grasps = load_grasps(folder);
  std::erase_if(grasps, [&](const Grasp& grasp) {
    return std::ranges::find(config.leave_out, grasp.id) != config.leave_out.end();
  });
  if (grasps.empty()) throw Error({.key = "leave_out", .expected = "a grasp", .found = "none"});
  return grasps;
}

BaseHand close_all(Hand hand, const std::vector<Grasp>& grasps, int threads) {
  BaseHand base{.hand = std::move(hand), .grasps = grasps, .closed = {}};
  base.closed.resize(grasps.size());
  parallel_for(grasps.size(), threads, [&](std::size_t i) {
    base.closed[i] = closed_pose(grasps[i], base.hand);
    base.grasps[i] = fitted_to(base.hand, grasps[i]);
  });
  return base;
}

// Around what people measure: a standard deviation of a tenth, of the length of an eighth.
HandShape draw_shape(RandomStream& random) {
  const HandShape base = default_hand_shape(random.uniform() < 0.5 ? "male" : "female");
  const auto about = [&random](double mean, double share) {
    return mean * (1 + share * std::clamp(random.normal(), -2.0, 2.0));
  };
  HandShape shape = in_proportion(base, {.length_mm = about(180, 0.09)});
  shape = in_proportion(shape, {.length_mm = shape.length_mm,
                                .breadth_mm = about(shape.breadth_mm, 0.06),
                                .finger_length_mm = about(shape.finger_length_mm, 0.03)});
  shape.finger_breadth_mm = about(shape.finger_breadth_mm, 0.08);
  shape.palm_thickness_mm = about(shape.palm_thickness_mm, 0.1);
  shape.forearm_breadth_mm = about(shape.forearm_breadth_mm, 0.08);
  shape.forearm_length_mm = std::max(shape.forearm_length_mm, 180.0);
  return shape;
}

// Measures that do not go together are drawn again.
Hand draw_made_hand(RandomStream& random) {
  for (int draw = 1;; ++draw) {
    try {
      return make_hand(draw_shape(random), kCoarseness);
    } catch (const Error&) {
      if (draw == kMostShapes) throw;
    }
  }
}

const BaseHand& nearest_base(const HandLibrary& library, double length) {
  return *std::ranges::min_element(library.bases, {}, [length](const BaseHand& base) {
    return std::abs(hand_length(base.hand.skeleton) - length);
  });
}

}  // namespace

HandLibrary load_hand_library(const SampleConfig& config, int threads) {
  HandLibrary library;
  const fs::path folder = config.grasps.empty() ? grasp_directory() : config.grasps;
  const std::vector<Grasp> grasps = chosen_grasps(config, folder);
  library.rest = load_rest_pose(folder);
  for (const fs::path& file : config.hands.empty() ? default_hands() : config.hands) {
    library.bases.push_back(close_all(load_hand(file), grasps, threads));
    library.assets.push_back({library.bases.back().hand.name, hash_hex(read_text(file))});
  }
  for (const Grasp& grasp : grasps) library.assets.push_back({grasp.name, grasp_hash(grasp)});
  return library;
}

SampleHand draw_hand(const HandLibrary& library, const SampleConfig& config, RandomStream random) {
  if (random.uniform() >= config.made_hands) {
    const BaseHand& base = library.bases[random.below(library.bases.size())];
    return {base.hand, &base, 1};
  }
  Hand hand = draw_made_hand(random);
  const double length = hand_length(hand.skeleton);
  const BaseHand& base = nearest_base(library, length);
  return {std::move(hand), &base, length / hand_length(base.hand.skeleton)};
}

}  // namespace graspdb
