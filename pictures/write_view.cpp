// SPDX-License-Identifier: MIT
#include "graspdb/pictures/write_view.h"

#include <algorithm>

#include "graspdb/core/file.h"
#include "graspdb/core/folder.h"
#include "graspdb/core/json/json_numbers.h"
#include "graspdb/renderer/image_io.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;
using json = nlohmann::ordered_json;

constexpr const char* kDescription = "view.json";

// `sheet.png` is drawn by those who want it.
FolderContent view_content() {
  return {.kind = "one view",
          .marker = ".graspdb-view",
          .files = {"shading.png", "label.png", "part.png", "depth.png", "depth.exr", "normal.exr",
                    "hand_amodal.png", "object_amodal.png", "sheet.png", kDescription}};
}

json or_null(const auto& optional) {
  return optional ? json(*optional) : json(nullptr);
}

json describe(const ViewSource& source) {
  json described{{"hand", source.hand},
                 {"variant", source.variant},
                 {"grasp", or_null(source.grasp)},
                 {"step", or_null(source.step)},
                 {"steps", or_null(source.steps)},
                 {"view", or_null(source.view)},
                 {"row", or_null(source.row)}};
  if (source.grasp) {
    described["grasp_name"] = source.grasp_name;
    described["object"] = source.object;
  }
  if (source.row) {
    described["database"] = source.database;
    described["content_hash"] = source.content_hash;
  }
  return described;
}

json describe_camera(const Camera& camera) {
  return {{"width_px", camera.intrinsics.width},
          {"height_px", camera.intrinsics.height},
          {"K", camera_matrix(camera.intrinsics)},
          {"distortion", "none"},
          {"frame", "OpenCV: x right, y down, z forward; integer pixels are pixel centres"}};
}

json describe_keypoints(const LabelledView& view) {
  json list = json::array();
  for (int i = 0; i < kKeypointCount; ++i) {
    list.push_back({{"name", keypoint_name(i)},
                    {"v", view.joint_states[static_cast<std::size_t>(i)]},
                    {"px", numbers(view.joints_px.col(i), kPixelsPerUnit)},
                    {"m", numbers(view.joints.col(i), kLengthsPerUnit)}});
  }
  return list;
}

json describe_angles(const JointAngles& angles) {
  json named = json::object();
  for (int i = 0; i < kAngleCount; ++i) {
    named[std::string(angle_info(i).name)] = rounded(angles[i], kAnglesPerUnit);
  }
  return named;
}

json describe_counts(const PixelCounts& counts) {
  return {{"visible_px", counts.visible},
          {"amodal_px", counts.amodal},
          {"occlusion", or_null(counts.occlusion())}};
}

json part_names() {
  json parts{{"0", "none"}};
  for (int bone = 0; bone < kBoneCount; ++bone) parts[std::to_string(bone + 1)] = bone_name(bone);
  return parts;
}

json describe_object(const std::optional<RigidTransform>& camera_from_object) {
  if (!camera_from_object) return nullptr;
  return {{"rotation", numbers(camera_from_object->rotation, kAnglesPerUnit)},
          {"translation_m", numbers(camera_from_object->translation, kLengthsPerUnit)}};
}

json describe(const LabelledView& view, const ViewSource& source) {
  const RigidTransform& camera_from_hand = view.camera.camera_from_hand;
  return {{"source", describe(source)},
          {"camera", describe_camera(view.camera)},
          {"camera_from_hand", numbers(camera_from_hand.rotation, kAnglesPerUnit)},
          {"wrist_m", numbers(camera_from_hand.translation, kLengthsPerUnit)},
          {"camera_from_object", describe_object(view.camera_from_object)},
          {"angles", describe_angles(view.angles)},
          {"keypoints", describe_keypoints(view)},
          {"hand", describe_counts(view.hand)},
          {"object", describe_counts(view.object)},
          {"labels", {{"0", "background"}, {"1", "hand"}, {"2", "object"}}},
          {"parts", part_names()},
          {"units",
           {{"angles", "rad"},
            {"m", "metres, camera frame"},
            {"px", "pixels"},
            {"depth.png", "planar z, mm, 0 = no hit"},
            {"depth.exr", "planar z, m, infinity = no hit"},
            {"normal.exr", "camera frame, unit length, 0 = no hit"}}}};
}

}  // namespace

Image<std::uint16_t> depth_in_mm(const Image<float>& meters) {
  static constexpr float kLargest = 65535;
  Image<std::uint16_t> depth(meters.width(), meters.height());
  std::transform(meters.begin(), meters.end(), depth.begin(), [](float z) {
    const float mm = std::isfinite(z) ? std::min(std::round(1000 * z), kLargest) : 0.0F;
    return static_cast<std::uint16_t>(mm);
  });
  return depth;
}

void write_view(const fs::path& directory, const LabelledView& view, const ViewSource& source) {
  renew_folder(directory, view_content());
  const View& picture = view.picture;
  write_png(directory / "shading.png", picture.shading);
  write_png(directory / "label.png", picture.label);
  write_png(directory / "part.png", picture.part);
  write_png16(directory / "depth.png", depth_in_mm(picture.depth));
  write_exr(directory / "depth.exr", picture.depth);
  write_exr(directory / "normal.exr", picture.normal);
  write_png(directory / "hand_amodal.png", picture.hand_amodal);
  write_png(directory / "object_amodal.png", picture.object_amodal);
  write_text(directory / kDescription, describe(view, source).dump(1) + "\n");
}

}  // namespace graspdb
