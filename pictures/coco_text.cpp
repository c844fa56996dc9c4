// SPDX-License-Identifier: MIT
#include "coco_text.h"

#include <fmt/format.h>

#include "graspdb/core/json/json_numbers.h"

namespace graspdb {
namespace {

using json = nlohmann::ordered_json;

constexpr int kHandCategory = 1;

json category() {
  json names = json::array(), skeleton = json::array();
  for (int i = 0; i < kKeypointCount; ++i) names.push_back(keypoint_name(i));
  for (int i = 1; i < kKeypointCount; ++i) {
    const bool first_of_digit = i % 4 == 1;
    skeleton.push_back({first_of_digit ? 1 : i, i + 1});  // from 1, as COCO has it
  }
  return {{"id", kHandCategory},
          {"name", "hand"},
          {"supercategory", "hand"},
          {"keypoints", std::move(names)},
          {"skeleton", std::move(skeleton)}};
}

// x, y, v of each; all 0 outside the picture.
json coco_keypoints(const LabelledView& view) {
  json list = json::array();
  for (int i = 0; i < kKeypointCount; ++i) {
    const KeypointState state = view.joint_states[static_cast<std::size_t>(i)];
    const bool inside = state != kOutsidePicture;
    for (int axis = 0; axis < 2; ++axis) {
      list.push_back(inside ? rounded(view.joints_px(axis, i), kPixelsPerUnit) : 0.0);
    }
    list.push_back(static_cast<int>(state));
  }
  return list;
}

json of_graspdb(const Database& database, std::size_t row, const LabelledView& view) {
  const Camera& camera = view.camera;
  return {{"row", row},
          {"grasp", database.grasp(row)},
          {"step", database.step(row)},
          {"view", database.view(row)},
          {"hand", database.info().hands[database.hand(row)].name},
          {"variant", database.info().variants[database.variant(row)]},
          {"K", camera_matrix(camera.intrinsics)},
          {"camera_from_hand", numbers(camera.camera_from_hand.rotation, kAnglesPerUnit)},
          {"wrist_m", numbers(camera.camera_from_hand.translation, kLengthsPerUnit)},
          {"angles", numbers(view.angles, kAnglesPerUnit)},
          {"keypoints_m", numbers(view.joints.transpose(), kLengthsPerUnit)}};
}

json conventions(const Database& database) {
  json angles = json::array(), grasps = json::object();
  for (int i = 0; i < kAngleCount; ++i) angles.push_back(angle_info(i).name);
  for (const GraspEntry& grasp : database.info().grasps) {
    grasps[std::to_string(grasp.id)] = grasp.name;
  }
  return {{"content_hash", database.content_hash()},
          {"pixel_rule",
           "Whole numbers in keypoints and K are pixel centres: the upper left pixel's centre is "
           "(0, 0). A bbox counts whole pixels: columns x to x + width - 1."},
          {"camera_frame", "OpenCV: x right, y down, z forward; metres"},
          {"mask_values", {{"0", "background"}, {"1", "hand"}, {"2", "object"}}},
          {"angle_names", std::move(angles)},
          {"angle_unit", "rad"},
          {"grasp_names", std::move(grasps)}};
}

}  // namespace

std::vector<std::uint32_t> run_lengths(const Image<std::uint8_t>& image, std::uint8_t value) {
  std::vector<std::uint32_t> runs = {0};
  bool inside = false;
  for (int x = 0; x < image.width(); ++x) {
    for (int y = 0; y < image.height(); ++y) {
      if ((image.at(x, y) == value) != inside) {
        inside = !inside;
        runs.push_back(0);
      }
      ++runs.back();
    }
  }
  return runs;
}

std::string coco_head(const Database& database) {
  const json info{{"description", "Rendered views of hands holding objects, made by graspdb"},
                  {"version", database.info().tool},
                  {"url", ""},
                  {"graspdb", conventions(database)}};
  const json license{{"id", 1},
                     {"name", "That of the hand and object files; those of graspdb are MIT"},
                     {"url", "https://opensource.org/license/mit"}};
  return fmt::format("\"info\":{},\n\"licenses\":[{}],\n\"categories\":[{}]", info.dump(),
                     license.dump(), category().dump());
}

std::string coco_file_name(std::size_t row) {
  return fmt::format("{:012}.png", row);
}

std::string coco_image(std::size_t row, int width, int height) {
  return json{{"id", row},
              {"file_name", coco_file_name(row)},
              {"width", width},
              {"height", height},
              {"license", 1}}
      .dump();
}

std::optional<std::string> coco_annotation(const Database& database, std::size_t row,
                                           const LabelledView& view) {
  const auto box = tight_box(visible_hand(view.picture));
  if (!box) return std::nullopt;
  const auto& label = view.picture.label;
  const auto labelled = std::ranges::count_if(
      view.joint_states, [](KeypointState state) { return state != kOutsidePicture; });
  return json{
      {"id", row + 1},  // pycocotools takes a 0 for no match
      {"image_id", row},
      {"category_id", kHandCategory},
      {"bbox", {box->x, box->y, box->width, box->height}},
      {"area", view.hand.visible},
      {"iscrowd", 0},
      {"segmentation",
       {{"size", {label.height(), label.width()}}, {"counts", run_lengths(label, kHandSurface)}}},
      {"keypoints", coco_keypoints(view)},
      {"num_keypoints", labelled},
      {"graspdb", of_graspdb(database, row, view)}}
      .dump();
}

}  // namespace graspdb
