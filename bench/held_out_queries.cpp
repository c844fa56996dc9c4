// SPDX-License-Identifier: MIT
#include "graspdb/bench/held_out_queries.h"

#include <Eigen/Geometry>

#include "graspdb/core/parallel.h"
#include "graspdb/core/random.h"
#include "graspdb/generator/row_poses.h"
#include "graspdb/tracker/describer.h"

namespace graspdb {
namespace {

constexpr int kTwelfths = 12;

Eigen::Matrix3d random_rotation(RandomStream& random) {
  Eigen::Quaterniond q(random.normal(), random.normal(), random.normal(), random.normal());
  return q.normalized().toRotationMatrix();
}

// The database's own configuration with other steps and without jitter.
BuildConfig between_the_steps(const Database& database) {
  BuildConfig config = load_config(database.path());
  config.steps = kTwelfths;
  config.jitter = {};
  return config;
}

}  // namespace

std::vector<DescriptorBytes> held_out_queries(const Database& database, int count) {
  const Describer describer(database);
  const RowPoses poses(between_the_steps(database));
  const auto& grasps = database.info().grasps;
  const BuildConfig& config = poses.config();
  std::vector<DescriptorBytes> queries(static_cast<std::size_t>(count));
  parallel_for(queries.size(), 0, [&](std::size_t i) {
    RandomStream random(1, i);
    const int grasp = grasps[random.below(grasps.size())].id;
    // Odd twelfths lie between the database's fifths.
    const int twelfth = 1 + 2 * static_cast<int>(random.below(kTwelfths / 2));
    const RowPose posed = poses.pose({.grasp = grasp, .step = twelfth});
    const Camera camera = crop_camera(random_rotation(random), posed.scene.center, config.distance,
                                      posed.scene.hand_vertices, config.resolution);
    const View view = render(posed.scene.scene, camera);
    queries[i] = describer.describe(view.shading, visible_hand(view));
  });
  std::erase_if(queries, [](const DescriptorBytes& query) { return query.empty(); });  // no hand
  return queries;
}

}  // namespace graspdb
