// SPDX-License-Identifier: MIT
#include "held_out_queries.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "console.h"
#include "graspdb/closing.h"
#include "graspdb/error.h"
#include "graspdb/file.h"
#include "graspdb/hog.h"
#include "graspdb/parallel.h"
#include "graspdb/posed_scene.h"
#include "graspdb/random.h"
#include "graspdb/rig.h"

namespace graspdb::cli {
namespace {

// How the database's own pictures were made.
struct PictureConfig {
  int resolution = 0;          // pixels a side
  double visible_forearm = 0;  // metres
};

PictureConfig picture_config(const Database& database) {
  try {
    const auto config = nlohmann::json::parse(database.info().config);
    return {config.at("resolution_px").get<int>(), config.at("visible_forearm_m").get<double>()};
  } catch (const nlohmann::json::exception& fault) {
    throw Error(
        {database.path().string(), "config", "resolution_px and visible_forearm_m", fault.what()});
  }
}

std::vector<Grasp> own_grasps(const Database& database) {
  const std::vector<GraspEntry>& own = database.info().grasps;
  std::vector<Grasp> grasps = load_grasps(grasp_directory());
  std::erase_if(grasps, [&own](const Grasp& grasp) {
    return std::none_of(own.begin(), own.end(),
                        [&grasp](const GraspEntry& entry) { return entry.id == grasp.id; });
  });
  if (grasps.empty()) {
    throw Error({database.path().string(), "grasps", "one or more of " + grasp_directory().string(),
                 "none of them"});
  }
  return grasps;
}

Eigen::Matrix3d random_rotation(RandomStream& random) {
  Eigen::Quaterniond q(random.normal(), random.normal(), random.normal(), random.normal());
  return q.normalized().toRotationMatrix();
}

}  // namespace

std::vector<Descriptor> held_out_queries(const Database& database, int count) {
  const DatabaseInfo& info = database.info();
  const PictureConfig config = picture_config(database);
  const Hand whole =
      load_hand(data_directory() / "assets/hands" / (info.hands.front().name + ".glb"));
  const Hand hand = with_visible_forearm(whole, config.visible_forearm);
  const JointAngles rest = load_rest_pose(grasp_directory());
  std::vector<Grasp> grasps = own_grasps(database);
  for (Grasp& grasp : grasps) grasp = fitted_to(whole, std::move(grasp));
  std::vector<GraspPose> closed;
  for (const Grasp& grasp : grasps) closed.push_back(closed_pose(grasp, whole));
  const HogOptions hog = hog_from_name(info.hog, database.path().string());
  const bool held = info.variants.front() == "held";
  std::vector<Descriptor> queries(static_cast<std::size_t>(count));
  parallel_for(queries.size(), 0, [&](std::size_t i) {
    RandomStream random(1, i);
    const std::size_t which = random.below(grasps.size());
    // Odd twelfths lie between the database's fifths.
    const int twelfth = 1 + 2 * static_cast<int>(random.below(6));
    const GraspPose pose = pose_at_step(grasps[which], rest, closed[which], twelfth, 12);
    const PosedScene posed = pose_scene(hand, pose, held ? grasps[which].object.get() : nullptr);
    const Camera camera = crop_camera(random_rotation(random), posed.centre, info.camera_distance,
                                      posed.hand_vertices, config.resolution);
    const View view = render(posed.scene, camera);
    queries[i] = describe(view.shading, visible_hand(view), hog);
  });
  return queries;
}

}  // namespace graspdb::cli
