// SPDX-License-Identifier: MIT
#include "graspdb/hand_maker.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "glb.h"
#include "graspdb/error.h"
#include "graspdb/file.h"
#include "proportions.h"
#include "simplify.h"
#include "skin.h"

namespace graspdb {
namespace {

constexpr double kCellMm = 2.2;
constexpr std::size_t kTriangleCount = 10000;
constexpr double kSkinAlbedo = .86;  // nails are brighter than skin

BoneFramesMm in_millimetres(BoneFramesMm frames) {
  for (RigidTransform& frame : frames) frame.translation *= 1000;
  return frames;
}

HandSurface surface_of(const HandShape& shape, double width, const Skeleton& skeleton) {
  std::array<Eigen::Vector3d, 5> tips = skeleton.tip_in_distal;
  for (Eigen::Vector3d& tip : tips) tip *= 1000;
  const BoneFramesMm frames = in_millimetres(palm_from_bones(skeleton, bind_angles()));
  return {flesh_of_shape(shape, width, frames, tips), width, shape.forearm_length_mm};
}

// How far the flesh reaches from a joint, at whatever height it reaches furthest.
double reach_mm(const HandSurface& surface, const Eigen::Vector3d& joint,
                const Eigen::Vector3d& direction) {
  double furthest = 0;
  for (int height = -12; height <= 6; height += 2) {
    double reach = 0;
    for (int step = 0; step < 50; ++step) {
      reach -= surface.distance(joint + Eigen::Vector3d(0, 0, height) + reach * direction);
    }
    furthest = std::max(furthest, reach);
  }
  return furthest;
}

// Along the line through the outer two knuckles.
double knuckle_breadth_mm(const HandSurface& surface, const Skeleton& skeleton) {
  const auto& zero = skeleton.palm_from_bone_at_zero;
  const Eigen::Vector3d index = 1000 * zero[finger_bone(0, kProximal)].translation;
  const Eigen::Vector3d little = 1000 * zero[finger_bone(3, kProximal)].translation;
  const Eigen::Vector3d across = (little - index).normalized();
  return (little - index).norm() + reach_mm(surface, index, -across) +
         reach_mm(surface, little, across);
}

// The scale across the hand at which it is as broad as asked.
double fitting_width(const HandShape& shape) {
  double width = shape.breadth_mm / kTableBreadthMm;
  for (int step = 0; step < 4; ++step) {
    const Skeleton skeleton = skeleton_of_shape(shape, width);
    width *= shape.breadth_mm / knuckle_breadth_mm(surface_of(shape, width, skeleton), skeleton);
  }
  return width;
}

double nail_share(const HandSurface& surface, const Eigen::Vector3d& point) {
  double share = 0;
  for (const Nail& nail : surface.flesh().nails) share = std::max(share, nail_share(nail, point));
  return share;
}

// Few triangles, but all of them on the nails, where the grey changes.
RawMesh reduced(const HandSurface& surface, const RawMesh& fine) {
  std::vector<bool> kept;
  for (const Eigen::Vector3d& v : fine.vertices) kept.push_back(nail_share(surface, v) > 0);
  return simplified(fine, kTriangleCount, kept);
}

Mesh finished_mesh(const HandSurface& surface, const RawMesh& raw) {
  Mesh mesh;
  for (const Eigen::Vector3d& vertex : raw.vertices) {
    mesh.vertices.push_back((vertex / 1000).cast<float>());
    mesh.normals.push_back(surface.gradient(vertex).normalized().cast<float>());
    const double albedo = std::lerp(kSkinAlbedo, 1.0, nail_share(surface, vertex));
    mesh.albedo.push_back(static_cast<float>(albedo));
  }
  mesh.triangles = raw.triangles;
  return mesh;
}

void check(const HandShape& shape) {
  const auto within = [&](const char* measure, double value, double low, double high) {
    if (value >= low && value <= high) return;
    throw Error({.file = "hand " + shape.name,
                 .key = measure,
                 .expected = fmt::format("{} to {}", low, high),
                 .found = fmt::format("{}", value)});
  };
  within("length_mm", shape.length_mm, 100, 240);
  within("breadth_mm", shape.breadth_mm, .36 * shape.length_mm, .54 * shape.length_mm);
  within("finger_length", shape.finger_length, .8, 1.2);
  within("finger_thickness", shape.finger_thickness, .8, 1.15);
  within("palm_thickness", shape.palm_thickness, .8, 1.25);
  within("forearm_thickness", shape.forearm_thickness, .75, 1.3);
  within("forearm_length_mm", shape.forearm_length_mm, 60, 250);
}

std::string rig_map_text(const Hand& hand) {
  const Eigen::Vector3d nail = hand.palm_from_bone_at_bind[kThumbDistal].rotation.col(2);
  std::string text = fmt::format(
      "# Which joint of {}.glb is which of graspdb's (docs/hands.md).\n"
      "handedness = \"right\"\n"
      "# The way the thumb's nail faces in the file's rest pose, in the file's coordinates.\n"
      "thumb_nail = [{}, {}, {}]\n\n[bones]\n",
      hand.name, nail.x(), nail.y(), nail.z());
  for (int bone = 0; bone < kBoneCount; ++bone) {
    text += fmt::format("{0} = [\"{0}\"]\n", bone_name(bone));
  }
  text += "\n[tips]\n";
  for (const std::string& tip : kTipNames) {
    text += fmt::format("{} = \"{}\"\n", tip.substr(0, tip.find('_')), tip);
  }
  return text;
}

}  // namespace

HandShape default_hand_shape(const std::string& name) {
  const HandShape shapes[] = {
      {.name = "male"},
      {.name = "female",
       .length_mm = 180,
       .breadth_mm = 78,
       .finger_thickness = .96,
       .palm_thickness = .95,
       .forearm_thickness = .93},
      {.name = "slender",
       .length_mm = 190,
       .breadth_mm = 76,
       .finger_length = 1.04,
       .finger_thickness = .94,
       .palm_thickness = .92,
       .forearm_thickness = .88},
      {.name = "child",
       .length_mm = 140,
       .breadth_mm = 66,
       .finger_length = .95,
       .finger_thickness = 1.03,
       .palm_thickness = 1.06,
       .forearm_thickness = 1.0},
  };
  for (const HandShape& shape : shapes) {
    if (shape.name == name) return shape;
  }
  throw Error({.key = "hand", .expected = "male, female, slender or child", .found = name});
}

Hand make_hand(const HandShape& shape) {
  check(shape);
  const double width = fitting_width(shape);
  Hand hand{.name = shape.name, .skeleton = skeleton_of_shape(shape, width)};
  hand.palm_from_bone_at_bind = palm_from_bones(hand.skeleton, bind_angles());
  const HandSurface surface = surface_of(shape, width, hand.skeleton);
  RawMesh fine = mesh_surface(surface, kCellMm * width);
  relax(surface, 6, fine);
  RawMesh mesh = reduced(surface, fine);
  relax(surface, 4, mesh);
  GRASPDB_CHECK(is_sphere_like(mesh));
  hand.bind_mesh = finished_mesh(surface, mesh);
  hand.weights = skin_weights(surface, mesh, in_millimetres(hand.palm_from_bone_at_bind), width);
  return hand;
}

void write_hand(const Hand& hand, const std::filesystem::path& glb) {
  write_text(glb, hand_to_glb(hand));
  std::filesystem::path rig_map = glb;
  write_text(rig_map.replace_extension(".rig.toml"), rig_map_text(hand));
}

}  // namespace graspdb
