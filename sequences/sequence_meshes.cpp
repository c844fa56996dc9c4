// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <bit>
#include <span>

#include "graspdb/core/file.h"
#include "graspdb/core/folder.h"
#include "graspdb/core/json/json_numbers.h"
#include "graspdb/renderer/image_io.h"
#include "graspdb/sequences/sequence.h"

namespace graspdb {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little);

constexpr const char* kHeader = "meshes.json";

FolderContent meshes_content() {
  return {.kind = "meshes of frames",
          .marker = ".graspdb-meshes",
          .files = {kHeader, "hand_triangles.u32", "hand_bind.f32", "hand_bones.u8",
                    "hand_vertices.f32", "object_triangles.u32", "object_vertices.f32",
                    "labels/" + digits(6) + ".png"}};
}

template <typename Value>
void write_array(const fs::path& file, const std::vector<Value>& values) {
  FileAside out(file);
  out.write(std::as_bytes(std::span(values)));
  out.commit();
}

json sizes(const Mesh& mesh) {
  return {{"vertices", mesh.vertices.size()}, {"triangles", mesh.triangles.size()}};
}

json describe_frame(const Hand& hand, const FrameGeometry& frame) {
  const RigidTransform& camera_from_hand = frame.camera_from_hand;
  const auto hand_from_bone = hand_from_bones(hand.skeleton, frame.pose.angles);
  return {{"camera_from_object", numbers(camera_from_hand * frame.pose.hand_from_object)},
          {"camera_from_forearm", numbers(camera_from_hand * hand_from_bone[kForearm])},
          {"towards_light", numbers(frame.towards_light)}};
}

json bones_at_bind(const Hand& hand) {
  json bones = json::array();
  for (int bone = 0; bone < kBoneCount; ++bone) {
    bones.push_back(
        {{"name", bone_name(bone)},
         {"hand_from_bone", numbers(hand.hand_from_bone_at_bind[static_cast<std::size_t>(bone)])}});
  }
  return bones;
}

// Those of all frames, in the camera frame.
void write_hand_vertices(const MeshFrames& meshes, const fs::path& file) {
  FileAside out(file);
  for (const FrameGeometry& frame : meshes.frames) {
    std::vector<Eigen::Vector3f> vertices = pose_skin(meshes.hand, frame.pose.angles).vertices;
    for (Eigen::Vector3f& vertex : vertices)
      vertex = (frame.camera_from_hand * vertex.cast<double>()).cast<float>();
    out.write(std::as_bytes(std::span(vertices)));
  }
  out.commit();
}

void write_labels(const MeshFrames& meshes, const fs::path& folder) {
  fs::create_directory(folder);
  for (std::size_t i = 0; i < meshes.frames.size(); ++i)
    write_png(folder / fmt::format("{:06}.png", i), frame_labels(meshes, i));
}

json describe(const MeshFrames& meshes) {
  json header = {{"name", meshes.name},
                 {"frames_per_second", meshes.frames_per_second},
                 {"visible_forearm_m", meshes.visible_forearm},
                 {"camera", camera_json(meshes.camera)},
                 {"skin_bgr", numbers(meshes.skin_bgr)},
                 {"object_bgr", numbers(meshes.object_bgr)},
                 {"hand", sizes(meshes.hand.bind_mesh)},
                 {"bones", bones_at_bind(meshes.hand)},
                 {"object", meshes.object ? sizes(meshes.object->mesh()) : json()},
                 {"frames", json::array()}};
  for (const FrameGeometry& frame : meshes.frames)
    header["frames"].push_back(describe_frame(meshes.hand, frame));
  return header;
}

}  // namespace

void write_meshes(const MeshFrames& meshes, const fs::path& directory) {
  renew_folder(directory, meshes_content());
  const Hand& hand = meshes.hand;
  write_array(directory / "hand_triangles.u32", hand.bind_mesh.triangles);
  write_array(directory / "hand_bind.f32", hand.bind_mesh.vertices);
  write_array(directory / "hand_bones.u8", strongest_bones(hand));
  write_hand_vertices(meshes, directory / "hand_vertices.f32");
  if (meshes.object) {
    write_array(directory / "object_triangles.u32", meshes.object->mesh().triangles);
    write_array(directory / "object_vertices.f32", meshes.object->mesh().vertices);
  }
  write_labels(meshes, directory / "labels");
  write_text(directory / kHeader, describe(meshes).dump(1) + "\n");
}

MeshFrames mesh_frames(const SequenceRenderer& renderer) {
  const SequenceSpec& spec = renderer.spec();
  MeshFrames meshes{.name = spec.name,
                    .frames_per_second = spec.frames_per_second,
                    .camera = spec.camera,
                    .hand = renderer.hand(),
                    .visible_forearm = spec.visible_forearm,
                    .object = spec.object_visible ? spec.grasp.object : nullptr,
                    .skin_bgr = spec.look.skin_bgr,
                    .object_bgr = spec.look.object_bgr,
                    .frames = {}};
  for (int i = 0; i < spec.frame_count(); ++i) meshes.frames.push_back(renderer.geometry(i));
  return meshes;
}

}  // namespace graspdb
