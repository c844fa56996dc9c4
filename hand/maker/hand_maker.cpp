// SPDX-License-Identifier: MIT
#include "graspdb/hand/maker/hand_maker.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit.h"
#include "glb.h"
#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/geometry/topology.h"
#include "graspdb/hand/digits.h"
#include "proportions.h"
#include "simplify.h"
#include "skin.h"

namespace graspdb {
namespace {

constexpr double kCellMm = 1.9;
constexpr std::size_t kTriangleCount = 10000;
// Nails are brighter than skin, in a dark fold.
constexpr double kSkinAlbedo = .86, kNailAlbedo = 1, kFoldAlbedo = .70;
constexpr double kFoldEnd = 1.4;  // in the unit of distance_from_nail

double distance_from_nails(const HandSurface& surface, const Eigen::Vector3d& point) {
  double distance = std::numeric_limits<double>::infinity();
  for (const Nail& nail : surface.flesh().nails) {
    distance = std::min(distance, distance_from_nail(nail, point));
  }
  return distance;
}

// From the nail's middle outwards.
double albedo_at(double distance) {
  const auto blended = [distance](double from, double to, double a, double b) {
    return std::lerp(a, b, std::clamp((distance - from) / (to - from), 0.0, 1.0));
  };
  return distance < 1.1 ? blended(.85, 1.1, kNailAlbedo, kFoldAlbedo)
                        : blended(1.1, kFoldEnd, kFoldAlbedo, kSkinAlbedo);
}

// Few triangles, but all of them on the nails, where the grey changes.
RawMesh reduced(const HandSurface& surface, const RawMesh& fine, std::size_t triangles) {
  std::vector<bool> kept;
  for (const Eigen::Vector3d& v : fine.vertices) {
    kept.push_back(distance_from_nails(surface, v) < kFoldEnd);
  }
  return simplified(fine, triangles, kept);
}

Mesh finished_mesh(const HandSurface& surface, const RawMesh& raw) {
  Mesh mesh;
  for (const Eigen::Vector3d& vertex : raw.vertices) {
    mesh.vertices.push_back((vertex / 1000).cast<float>());
    mesh.normals.push_back(surface.gradient(vertex).normalized().cast<float>());
    mesh.albedo.push_back(static_cast<float>(albedo_at(distance_from_nails(surface, vertex))));
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
  within("length_mm", shape.length_mm, kMeasureRanges.length_mm.low, kMeasureRanges.length_mm.high);
  within("breadth_mm", shape.breadth_mm, .36 * shape.length_mm, .54 * shape.length_mm);
  const double length = shape.length_mm, breadth = shape.breadth_mm;
  within("finger_length_mm", shape.finger_length_mm, .49 * length, .60 * length);
  within("finger_breadth_mm", shape.finger_breadth_mm, .185 * breadth, .262 * breadth);
  within("palm_thickness_mm", shape.palm_thickness_mm, .25 * breadth, .42 * breadth);
  within("forearm_breadth_mm", shape.forearm_breadth_mm, .5 * breadth, .87 * breadth);
  within("forearm_length_mm", shape.forearm_length_mm, kMeasureRanges.forearm_length_mm.low,
         kMeasureRanges.forearm_length_mm.high);
}

constexpr const char* kOrigin = "made by graspdb hand make";

// A map of somebody else's hand is hours of work.
void require_own_map(const std::filesystem::path& rig_map) {
  if (!std::filesystem::exists(rig_map)) return;
  if (read_text(rig_map).find(kOrigin) != std::string::npos) return;
  throw Error({rig_map.string(), "origin", fmt::format("'{}', or no such file", kOrigin),
               "a rig map from elsewhere"});
}

std::string rig_map_text(const Hand& hand) {
  const Eigen::Vector3d nail = hand.hand_from_bone_at_bind[kThumbDistal].rotation.col(2);
  std::string text = fmt::format(
      "# Which joint of {}.glb is which of graspdb's (docs/hands.md).\n"
      "origin = \"{}\"\n"
      "licence = \"MIT\"\n"
      "handedness = \"right\"\n"
      "# The way the thumb's nail faces in the file's rest pose, in the file's coordinates.\n"
      "thumb_nail = [{}, {}, {}]\n\n[bones]\n",
      hand.name, kOrigin, nail.x(), nail.y(), nail.z());
  for (int bone = 0; bone < kBoneCount; ++bone) {
    text += fmt::format("{0} = [\"{0}\"]\n", bone_name(bone));
  }
  text += "\n[tips]\n";
  for (int digit = 0; digit < kDigitCount; ++digit) {
    text += fmt::format("{} = \"{}\"\n", digit_name(digit), keypoint_name(tip_keypoint(digit)));
  }
  return text;
}

}  // namespace

HandShape default_hand_shape(const std::string& name) {
  const HandShape shapes[] = {
      {"male", 193, 88, 106, 20.5, 28, 59, 180},
      {"female", 180, 78, 99, 18, 24.5, 51.5, 180},
      {"slender", 190, 76, 107, 17.5, 23.5, 50, 180},
      {"child", 140, 66, 75.5, 15, 20, 45, 160},
  };
  for (const HandShape& shape : shapes) {
    if (shape.name == name) return shape;
  }
  throw Error({.key = "hand", .expected = "male, female, slender or child", .found = name});
}

HandShape in_proportion(const HandShape& base, const WantedMeasures& wanted) {
  HandShape shape = base;
  shape.length_mm = wanted.length_mm.value_or(base.length_mm);
  const double along = shape.length_mm / base.length_mm;
  shape.breadth_mm = wanted.breadth_mm.value_or(base.breadth_mm * along);
  const double across = shape.breadth_mm / base.breadth_mm;
  shape.finger_length_mm = wanted.finger_length_mm.value_or(base.finger_length_mm * along);
  shape.forearm_length_mm = wanted.forearm_length_mm.value_or(base.forearm_length_mm * along);
  shape.finger_breadth_mm = wanted.finger_breadth_mm.value_or(base.finger_breadth_mm * across);
  shape.palm_thickness_mm = wanted.palm_thickness_mm.value_or(base.palm_thickness_mm * across);
  shape.forearm_breadth_mm = wanted.forearm_breadth_mm.value_or(base.forearm_breadth_mm * across);
  return shape;
}

Hand make_hand(const HandShape& shape, double coarseness) {
  GRASPDB_CHECK(coarseness >= 1);
  check(shape);
  const FleshScales scales = fitting_scales(shape);
  const double width = scales.width;
  Hand hand{.name = shape.name, .skeleton = skeleton_of_shape(shape, width)};
  hand.hand_from_bone_at_bind = hand_from_bones(hand.skeleton, bind_angles());
  const HandSurface surface = surface_of_shape(shape, scales);
  RawMesh fine = mesh_surface(surface, kCellMm * width * coarseness);
  relax(surface, 3, fine);
  RawMesh mesh =
      reduced(surface, fine, static_cast<std::size_t>(kTriangleCount / (coarseness * coarseness)));
  relax(surface, 4, mesh);
  GRASPDB_CHECK(is_sphere_like(mesh.vertices.size(), mesh.triangles));
  hand.bind_mesh = finished_mesh(surface, mesh);
  hand.weights = skin_weights(surface, mesh, bind_frames_mm(hand.skeleton), width);
  return hand;
}

void write_hand(const Hand& hand, const std::filesystem::path& glb) {
  const std::filesystem::path rig_map = std::filesystem::path(glb).replace_extension(".rig.toml");
  require_own_map(rig_map);
  write_text(glb, hand_to_glb(hand));
  write_text(rig_map, rig_map_text(hand));
}

}  // namespace graspdb
