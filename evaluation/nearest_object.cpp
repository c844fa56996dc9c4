// SPDX-License-Identifier: MIT
#include "graspdb/evaluation/nearest_object.h"

#include <fmt/format.h>

#include <algorithm>

#include "graspdb/generator/build_config.h"
#include "graspdb/grasps/closing.h"
#include "graspdb/grasps/grasp.h"

namespace graspdb {
namespace {

std::string size_text(const Eigen::Vector3d& mm) {
  return fmt::format("{:.0f} x {:.0f} x {:.0f} mm", mm[0], mm[1], mm[2]);
}

double mean_difference(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return (a - b).cwiseAbs().mean();
}

}  // namespace

DatabaseObjects::DatabaseObjects(const Database& database) {
  const std::optional<BuildConfig> config = stored_config(database);
  if (!config || !std::filesystem::is_directory(config->grasps)) return;
  for (const Grasp& grasp : load_grasps(config->grasps)) {
    const auto built = config->grasp_hashes.find(grasp.id);
    if (built != config->grasp_hashes.end() && built->second == grasp_hash(grasp))
      objects_.push_back(object_of(grasp));
  }
}

DatabaseObjects::Object DatabaseObjects::object_of(const Grasp& grasp) {
  Eigen::Vector3d sides = 2000 * grasp.object->half_extents();
  std::sort(sides.begin(), sides.end());
  return {grasp.object_name, sides};
}

std::string DatabaseObjects::beside(const SequenceSpec& sequence) const {
  const Object own = object_of(sequence.grasp);
  std::string text =
      fmt::format("{} {}{}", own.name, size_text(own.sides_mm),
                  sequence.object_visible ? "" : " (not there: the hand moves without it)");
  if (objects_.empty()) return text;
  const auto nearest =
      std::min_element(objects_.begin(), objects_.end(), [&](const Object& a, const Object& b) {
        return mean_difference(a.sides_mm, own.sides_mm) <
               mean_difference(b.sides_mm, own.sides_mm);
      });
  return fmt::format("{}; nearest in the database: {} {}, mean difference {:.0f} mm", text,
                     nearest->name, size_text(nearest->sides_mm),
                     mean_difference(nearest->sides_mm, own.sides_mm));
}

}  // namespace graspdb
