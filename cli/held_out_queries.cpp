// SPDX-License-Identifier: MIT
#include "held_out_queries.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "console.h"
#include "graspdb/error.h"
#include "graspdb/file.h"
#include "graspdb/hog.h"
#include "graspdb/parallel.h"
#include "graspdb/posed_scene.h"
#include "graspdb/random.h"
#include "graspdb/rig.h"

namespace graspdb::cli {
namespace {

constexpr int kResolution = 128;
constexpr double kVisibleForearm = 0.015;

Eigen::Matrix3d random_rotation(RandomStream& random) {
  Eigen::Quaterniond q(random.normal(), random.normal(), random.normal(), random.normal());
  return q.normalized().toRotationMatrix();
}

}  // namespace

std::vector<Descriptor> held_out_queries(const Database& database, int count) {
  const DatabaseInfo& info = database.info();
  const Hand whole =
      load_hand(data_directory() / "assets/hands" / (info.hands.front().name + ".glb"));
  const Hand hand = with_visible_forearm(whole, kVisibleForearm);
  const JointAngles rest = load_rest_pose(grasp_directory());
  std::vector<Grasp> grasps = load_grasps(grasp_directory());
  std::erase_if(grasps, [&](const Grasp& grasp) {
    return std::none_of(info.grasps.begin(), info.grasps.end(),
                        [&](const GraspEntry& e) { return e.id == grasp.id; });
  });
  GRASPDB_CHECK(!grasps.empty());
  const bool held = info.variants.front() == "held";
  std::vector<Descriptor> queries(static_cast<std::size_t>(count));
  parallel_for(queries.size(), 0, [&](std::size_t i) {
    RandomStream random(1, i);
    const Grasp& grasp = grasps[random.below(grasps.size())];
    // Odd twelfths lie between the database's fifths.
    const int twelfth = 1 + 2 * static_cast<int>(random.below(6));
    const GraspPose pose = pose_at_step(grasp, rest, closed_pose(grasp, hand), twelfth, 12);
    const PosedScene posed = pose_scene(hand, pose, held ? grasp.object.get() : nullptr);
    const Camera camera = crop_camera(random_rotation(random), posed.centre, info.camera_distance,
                                      posed.hand_vertices, kResolution);
    const View view = render(posed.scene, camera);
    queries[i] = describe(view.shading, visible_hand(view),
                          hog_from_name(info.hog, database.path().string()));
  });
  return queries;
}

}  // namespace graspdb::cli
