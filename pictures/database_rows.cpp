// SPDX-License-Identifier: MIT
#include "graspdb/pictures/database_rows.h"

#include <fmt/format.h>

#include <set>

#include "graspdb/core/error.h"

namespace graspdb {
namespace {

constexpr double kSameAngle = 1e-4;  // radians; labels are rounded to float32

BuildConfig config_for(const Database& database, std::span<const std::size_t> rows,
                       std::optional<int> resolution) {
  BuildConfig config = load_config(database.path());
  std::set<int> grasps;
  for (const std::size_t row : rows) grasps.insert(database.grasp(row));
  config.only.assign(grasps.begin(), grasps.end());
  if (resolution) config.resolution = *resolution;
  return config;
}

[[noreturn]] void fail_changed(const Database& database, std::size_t row, const char* what) {
  throw Error({database.path().string(), fmt::format("row {}", row),
               fmt::format("the {} that its label has", what),
               "another one: the closed grasp, the rest pose or the program has changed since"});
}

}  // namespace

DatabaseRows::DatabaseRows(const Database& database, std::span<const std::size_t> rows,
                           std::optional<int> resolution)
    : database_(database), poses_(config_for(database, rows, resolution)) {
  GRASPDB_CHECK(!rows.empty());
}

PoseKey DatabaseRows::key(std::size_t row) const {
  return {database_.hand(row), database_.variant(row), database_.grasp(row), database_.step(row)};
}

const Grasp& DatabaseRows::grasp(std::size_t row) const {
  return poses_.grasp(database_.grasp(row));
}

RowPose DatabaseRows::pose(std::size_t row) const {
  RowPose pose = poses_.pose(key(row));
  const LabelPose label = unpack_label(database_.label(row));
  const double difference = (pose.pose.angles - label.angles).cwiseAbs().maxCoeff();
  if (!is_finite(database_.label(row)) || !(difference < kSameAngle))
    fail_changed(database_, row, "joint angles");
  return pose;
}

Subject DatabaseRows::subject(std::size_t row) const {
  return {poses_.hand(key(row).hand), pose(row)};
}

LabelledView DatabaseRows::view(const Subject& subject, std::size_t row,
                                const Layers& layers) const {
  const Camera camera = poses_.camera(subject.pose(), database_.view(row));
  const Eigen::Matrix3d rotation = unpack_label(database_.label(row)).rotation;
  if (!(angle_between(rotation, camera.camera_from_hand.rotation) < kSameAngle)) {
    fail_changed(database_, row, "view");
  }
  return subject.seen(camera, poses_.light(key(row), database_.view(row)), layers);
}

}  // namespace graspdb
