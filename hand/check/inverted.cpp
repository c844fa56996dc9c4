// SPDX-License-Identifier: MIT
#include "inverted.h"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include "graspdb/core/parallel.h"
#include "graspdb/geometry/triangle.h"
#include "graspdb/hand/named_poses.h"
#include "lines.h"

namespace graspdb {
namespace {

// How each vertex' surroundings are turned from the bind pose: the blend of its bones' rotations.
std::vector<Eigen::Matrix3f> turns_of_vertices(const Hand& hand,
                                               const PerBone<RigidTransform>& hand_from_bone) {
  PerBone<Eigen::Matrix3f> turns;
  for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
    turns[bone] =
        (hand_from_bone[bone].rotation * hand.hand_from_bone_at_bind[bone].rotation.transpose())
            .cast<float>();
  }
  std::vector<Eigen::Matrix3f> blends(hand.weights.size(), Eigen::Matrix3f::Zero());
  for (std::size_t v = 0; v < blends.size(); ++v) {
    const SkinWeights& skin = hand.weights[v];
    for (std::size_t i = 0; i < 4; ++i) {
      if (skin.weight[i] > 0) blends[v] += skin.weight[i] * turns[skin.bone[i]];
    }
  }
  return blends;
}

struct InvertedCount {
  std::size_t all = 0;
  std::size_t open = 0;  // no skin lies over them: they show
};

InvertedCount count_inverted(const Hand& hand, const JointAngles& angles) {
  const PerBone<RigidTransform> frames = hand_from_bones(hand.skeleton, angles);
  const Mesh posed = pose_skin(hand, frames);
  const std::vector<Eigen::Matrix3f> turns = turns_of_vertices(hand, frames);
  std::vector<Corners> skin;
  for (const Triangle& t : posed.triangles) skin.push_back(corners_of(posed, t));
  InvertedCount count;
  for (std::size_t i = 0; i < skin.size(); ++i) {
    const Triangle& t = posed.triangles[i];
    const Eigen::Matrix3f turn = turns[t[0]] + turns[t[1]] + turns[t[2]];
    const Eigen::Vector3d expected = turn.cast<double>() * normal_of(corners_of(hand.bind_mesh, t));
    if (!(normal_of(skin[i]).dot(expected) < 0)) continue;
    const Eigen::Vector3d outwards = expected.normalized();
    // From a little above itself.
    const Eigen::Vector3d middle = (skin[i][0] + skin[i][1] + skin[i][2]) / 3;
    ++count.all;
    count.open += !distance_along(middle + 1e-6 * outwards, outwards, skin);
  }
  return count;
}

double percent(const Hand& hand, std::size_t triangles) {
  return 100 * static_cast<double>(triangles) /
         static_cast<double>(hand.bind_mesh.triangles.size());
}

void add_limit_lines(const Hand& hand, const AngleGroup& group, std::vector<HandCheckLine>& lines) {
  const std::vector<Limit> limits = limits_of(group);
  std::vector<InvertedCount> counts(limits.size());
  parallel_for(limits.size(), 0,
               [&](std::size_t i) { counts[i] = count_inverted(hand, limits[i].angles()); });
  Worst all, open;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    all.take(percent(hand, counts[i].all), [&] { return limits[i].text(); });
    open.take(static_cast<double>(counts[i].open), [&] { return limits[i].text(); });
  }
  Missing missing;
  if (group.first == kWristFlexion) missing.lacks_skin(hand, kForearm);
  lines.push_back(judged_unless(
      missing, fmt::format("inverted triangles, limits of {}", group.name), all, "%", at_most(.5)));
  lines.push_back(judged_unless(missing, fmt::format("inverted and seen, limits of {}", group.name),
                                open, "", at_most(2)));
}

}  // namespace

std::vector<HandCheckLine> check_inverted(const Hand& hand) {
  std::vector<HandCheckLine> lines;
  for (const char* pose : {"flat", "wrap", "pinch"}) {
    const InvertedCount count = count_inverted(hand, named_pose(pose));
    lines.push_back(judged(fmt::format("inverted triangles, {}", pose),
                           static_cast<double>(count.all), "", at_most(2)));
  }
  const InvertedCount fist = count_inverted(hand, named_pose("fist"));
  lines.push_back(judged("inverted triangles, fist", percent(hand, fist.all), "%", at_most(.5)));
  for (const AngleGroup& group : kAngleGroups) add_limit_lines(hand, group, lines);
  return lines;
}

}  // namespace graspdb
