// SPDX-License-Identifier: MIT
#include "graspdb/tracker/estimate_json.h"

#include <fmt/format.h>

#include "graspdb/core/error.h"
#include "graspdb/core/json/json_numbers.h"

namespace graspdb {
namespace {

using nlohmann::json;

constexpr std::size_t kListedHypotheses = 20;

void add_answer(json& line, const Estimate& estimate, const Database& database) {
  json hypotheses = json::array();
  for (const Hypothesis& h : estimate.hypotheses) {
    if (hypotheses.size() == kListedHypotheses) break;
    hypotheses.push_back({{"row", h.row}, {"roll_deg", h.roll_deg}, {"weight", h.weight}});
  }
  line["handedness"] = estimate.left_hand ? "left" : "right";
  line["row"] = estimate.row;
  line["roll_deg"] = estimate.roll_deg;
  line["distance"] = estimate.distance;
  line["grasp"] = {{"id", estimate.grasp},
                   {"name", grasp_name(database.info(), estimate.grasp)},
                   {"probability", estimate.grasp_probability}};
  line["step"] = estimate.step;
  line["camera_from_hand"] = numbers(estimate.camera_from_hand.rotation);
  line["wrist_m"] = numbers(estimate.camera_from_hand.translation);
  line["angles"] = numbers(estimate.angles);
  line["joints_m"] = points(estimate.joints);
  line["joints_px"] = points(estimate.joints_px);
  line["hypotheses"] = std::move(hypotheses);
}

}  // namespace

std::string why_no_answer(const Estimate& estimate) {
  switch (estimate.no_answer) {
    case NoAnswer::kNone:
      return "";
    case NoAnswer::kNoHand:
      return estimate.colorless ? "there is no colour to find a hand by"
                                : "nothing in the frame looks like a hand";
    case NoAnswer::kUnlike:
      return fmt::format("what was found resembles no row: the nearest is {:.2f} away",
                         estimate.distance);
    case NoAnswer::kNoRowFits:
      return "no row like it has a box of such a shape";
    case NoAnswer::kTooNear:
      return "the hand would reach behind the camera";
  }
  GRASPDB_CHECK(false);
}

std::string estimate_json(const FrameName& frame, const Estimate& estimate,
                          const Database& database, const Remarks& remarks) {
  const Box& box = estimate.box;
  json line = {{"frame", frame.number},
               {"time_s", frame.time},
               {"valid", estimate.valid},
               {"confidence", estimate.confidence},
               {"box", {box.x, box.y, box.width, box.height}},
               {"ms",
                {{"segment", estimate.ms.segment},
                 {"describe", estimate.ms.describe},
                 {"search", estimate.ms.search},
                 {"temporal", estimate.ms.temporal},
                 {"total", estimate.ms.total}}}};
  if (!frame.file.empty()) line["file"] = frame.file;
  if (frame.camera) {
    line["camera"] = camera_json(*frame.camera);
    line["camera"]["from"] = frame.camera_from;
  }
  if (estimate.valid) add_answer(line, estimate, database);
  if (!estimate.valid) line["why"] = why_no_answer(estimate);
  if (!remarks.notes.empty()) line["notes"] = remarks.notes;
  if (!remarks.warnings.empty()) line["warnings"] = remarks.warnings;
  return line.dump();
}

}  // namespace graspdb
