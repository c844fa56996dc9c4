// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include "angles.h"
#include "graspdb/hand/check/hand_check.h"
#include "inverted.h"
#include "lines.h"
#include "poses.h"
#include "reach.h"
#include "size.h"
#include "stated.h"
#include "surface.h"

namespace graspdb {
namespace {

double difference(const RigidTransform& a, const RigidTransform& b) {
  return std::max((a.rotation - b.rotation).cwiseAbs().maxCoeff(),
                  (a.translation - b.translation).cwiseAbs().maxCoeff());
}

double difference_of_frames(const Hand& a, const Hand& b) {
  double largest = 0;
  for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
    largest = std::max({largest,
                        difference(a.hand_from_bone_at_bind[bone], b.hand_from_bone_at_bind[bone]),
                        difference(a.skeleton.hand_from_bone_at_zero[bone],
                                   b.skeleton.hand_from_bone_at_zero[bone])});
  }
  for (std::size_t tip = 0; tip < 5; ++tip) {
    const Eigen::Vector3d apart = a.skeleton.tip_in_distal[tip] - b.skeleton.tip_in_distal[tip];
    largest = std::max(largest, apart.cwiseAbs().maxCoeff());
  }
  return largest;
}

double difference(const SkinWeights& a, const SkinWeights& b) {
  PerBone<double> apart{};
  for (std::size_t i = 0; i < 4; ++i) {
    apart[a.bone[i]] += a.weight[i];
    apart[b.bone[i]] -= b.weight[i];
  }
  double largest = 0;
  for (const double weight : apart) largest = std::max(largest, std::abs(weight));
  return largest;
}

double difference_of_skin(const Hand& a, const Hand& b) {
  if (a.bind_mesh.vertices.size() != b.bind_mesh.vertices.size() ||
      a.bind_mesh.triangles != b.bind_mesh.triangles) {
    return std::numeric_limits<double>::infinity();
  }
  double largest = 0;
  for (std::size_t v = 0; v < a.bind_mesh.vertices.size(); ++v) {
    const Eigen::Vector3f apart = a.bind_mesh.vertices[v] - b.bind_mesh.vertices[v];
    largest = std::max({largest, static_cast<double>(apart.cwiseAbs().maxCoeff()),
                        difference(a.weights[v], b.weights[v])});
  }
  return largest;
}

}  // namespace

std::vector<HandCheckLine> check_hand(const Hand& hand, const std::optional<AskedSize>& asked) {
  std::vector<HandCheckLine> lines;
  for (const std::vector<HandCheckLine>& part :
       {check_surface(hand), check_inverted(hand), check_poses(hand), check_reach(hand),
        check_size(hand, asked), check_angles(hand), check_stated(hand)}) {
    lines.insert(lines.end(), part.begin(), part.end());
  }
  return lines;
}

HandCheckLine check_made_again(const Hand& from_file, const std::optional<Hand>& made) {
  const Gate gate = at_most(1e-6);
  if (!made) return not_applicable("made again", "m", gate, "not one of graspdb's four hands");
  const double largest =
      std::max(difference_of_frames(from_file, *made), difference_of_skin(from_file, *made));
  return judged("made again", largest, "m", gate, std::isfinite(largest) ? "" : "other triangles");
}

}  // namespace graspdb
