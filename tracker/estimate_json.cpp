// SPDX-License-Identifier: MIT
#include "graspdb/tracker/estimate_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace graspdb {
namespace {

using nlohmann::json;

constexpr std::size_t kListedHypotheses = 20;

template <typename Matrix>
json columns(const Matrix& points) {
  json list = json::array();
  for (int i = 0; i < points.cols(); ++i) {
    json point = json::array();
    for (int d = 0; d < points.rows(); ++d) point.push_back(points(d, i));
    list.push_back(std::move(point));
  }
  return list;
}

json rotation(const Eigen::Matrix3d& r) {  // row-major
  return {r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)};
}

std::string grasp_name(const Database& database, int id) {
  const auto& grasps = database.info().grasps;
  const auto found =
      std::find_if(grasps.begin(), grasps.end(), [id](const GraspEntry& g) { return g.id == id; });
  return found == grasps.end() ? "" : found->name;
}

void add_answer(json& line, const Estimate& estimate, const Database& database) {
  json hypotheses = json::array();
  for (const Hypothesis& h : estimate.hypotheses) {
    if (hypotheses.size() == kListedHypotheses) break;
    hypotheses.push_back({{"row", h.row}, {"weight", h.weight}});
  }
  line["row"] = estimate.row;
  line["distance"] = estimate.distance;
  line["grasp"] = {{"id", estimate.grasp},
                   {"name", grasp_name(database, estimate.grasp)},
                   {"probability", estimate.grasp_probability}};
  line["step"] = estimate.step;
  line["camera_from_hand"] = rotation(estimate.camera_from_hand.rotation);
  line["wrist_m"] = columns(estimate.camera_from_hand.translation).front();
  line["angles"] = std::vector<double>(estimate.angles.begin(), estimate.angles.end());
  line["joints_m"] = columns(estimate.joints);
  line["joints_px"] = columns(estimate.joints_px);
  line["hypotheses"] = std::move(hypotheses);
}

}  // namespace

std::string estimate_json(int frame, double time_s, const Estimate& estimate,
                          const Database& database) {
  const Box& box = estimate.box;
  json line = {{"frame", frame},
               {"time_s", time_s},
               {"valid", estimate.valid},
               {"confidence", estimate.confidence},
               {"box", {box.x, box.y, box.width, box.height}},
               {"ms",
                {{"segment", estimate.ms.segment},
                 {"describe", estimate.ms.describe},
                 {"search", estimate.ms.search},
                 {"temporal", estimate.ms.temporal},
                 {"total", estimate.ms.total}}}};
  if (estimate.valid) add_answer(line, estimate, database);
  return line.dump();
}

}  // namespace graspdb
