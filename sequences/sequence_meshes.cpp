// SPDX-License-Identifier: MIT
#include <bit>
#include <span>

#include "graspdb/core/file.h"
#include "graspdb/core/folder.h"
#include "graspdb/core/json/json_numbers.h"
#include "graspdb/sequences/sequence.h"

namespace graspdb {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little);

constexpr const char* kHeader = "meshes.json";

FolderContent meshes_content() {
  return {.kind = "a sequence's meshes",
          .marker = ".graspdb-meshes",
          .files = {kHeader, "hand_triangles.u32", "hand_bind.f32", "hand_bones.u8",
                    "hand_vertices.f32", "object_triangles.u32", "object_vertices.f32"}};
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
void write_hand_vertices(const SequenceRenderer& renderer, const fs::path& file) {
  FileAside out(file);
  for (int i = 0; i < renderer.spec().frame_count(); ++i) {
    const FrameGeometry frame = renderer.geometry(i);
    std::vector<Eigen::Vector3f> vertices = pose_skin(renderer.hand(), frame.pose.angles).vertices;
    for (Eigen::Vector3f& vertex : vertices)
      vertex = (frame.camera_from_hand * vertex.cast<double>()).cast<float>();
    out.write(std::as_bytes(std::span(vertices)));
  }
  out.commit();
}

}  // namespace

void write_meshes(const SequenceRenderer& renderer, const fs::path& directory) {
  const SequenceSpec& spec = renderer.spec();
  const Hand& hand = renderer.hand();
  renew_folder(directory, meshes_content());
  write_array(directory / "hand_triangles.u32", hand.bind_mesh.triangles);
  write_array(directory / "hand_bind.f32", hand.bind_mesh.vertices);
  write_array(directory / "hand_bones.u8", strongest_bones(hand));
  write_hand_vertices(renderer, directory / "hand_vertices.f32");
  json header = {{"name", spec.name},
                 {"frames_per_second", spec.frames_per_second},
                 {"visible_forearm_m", spec.visible_forearm},
                 {"camera", camera_json(spec.camera)},
                 {"skin_bgr", numbers(spec.look.skin_bgr)},
                 {"object_bgr", numbers(spec.look.object_bgr)},
                 {"hand", sizes(hand.bind_mesh)},
                 {"bones", bones_at_bind(hand)},
                 {"object", nullptr},
                 {"frames", json::array()}};
  if (spec.object_visible) {
    const Mesh& object = spec.grasp.object->mesh();
    write_array(directory / "object_triangles.u32", object.triangles);
    write_array(directory / "object_vertices.f32", object.vertices);
    header["object"] = sizes(object);
  }
  for (int i = 0; i < spec.frame_count(); ++i)
    header["frames"].push_back(describe_frame(hand, renderer.geometry(i)));
  write_text(directory / kHeader, header.dump(1) + "\n");
}

}  // namespace graspdb
