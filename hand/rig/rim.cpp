// SPDX-License-Identifier: MIT
#include "rim.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace graspdb {
namespace {

using Eigen::Vector3d;

// How much skin may lie beyond the rim, and how much wider than it beside it.
constexpr double kRimDepthM = .002, kRimWidth = 1.5;

// Which bone moves most of some vertices, and how much of them palm and forearm do.
struct LoopShares {
  std::size_t strongest;
  double of_arm;  // 0..1
};
LoopShares shares_of(const std::vector<std::uint32_t>& loop, const RigSkin& skin) {
  PerBone<double> sums{};
  for (const std::uint32_t v : loop) {
    for (std::size_t b = 0; b < kBoneCount; ++b) sums[b] += skin.weights[v][b];
  }
  const auto strongest = std::max_element(sums.begin(), sums.end()) - sums.begin();
  return {static_cast<std::size_t>(strongest),
          (sums[kPalm] + sums[kForearm]) / static_cast<double>(loop.size())};
}

// Whether no skin lies nearer to the elbow than a loop, or wide around it.
bool is_rim_of(const Mesh& mesh, const std::vector<Triangle>& triangles,
               const std::vector<std::uint32_t>& loop, const Vector3d& elbow) {
  const Rim rim(loop, elbow, mesh);
  const auto beyond = [&](std::uint32_t v) { return mesh.vertices[v].cast<double>().dot(elbow); };
  const auto [low, high] = std::ranges::minmax_element(loop, {}, beyond);
  for (const Triangle& t : triangles) {
    for (const std::uint32_t v : t) {
      if (beyond(v) > beyond(*high) + kRimDepthM) return false;
      const bool is_beside = beyond(v) > beyond(*low);
      const double width = rim.across(mesh.vertices[v].cast<double>()).norm();
      if (is_beside && width > kRimWidth * rim.radius()) return false;
    }
  }
  return true;
}

}  // namespace

std::optional<std::string> fault_of_rim(const std::vector<std::uint32_t>& loop,
                                        const Vector3d& elbow,
                                        const std::vector<Triangle>& triangles,
                                        const RigSkin& skin) {
  const Rim rim(loop, elbow, skin.mesh);
  const double beyond = rim.center().dot(elbow);
  const Vector3d from_axis = rim.center() - beyond * elbow;
  const LoopShares shares = shares_of(loop, skin);
  const bool is_good = shares.of_arm > .5 && beyond > 0 && from_axis.norm() < rim.radius() &&
                       is_rim_of(skin.mesh, triangles, loop, elbow);
  if (is_good) return std::nullopt;
  return fmt::format("an open loop of {} edges on {}, {:.0f} mm {} the wrist, not round the end",
                     loop.size(), bone_name(static_cast<int>(shares.strongest)),
                     1000 * std::abs(beyond), beyond > 0 ? "beyond" : "before");
}

}  // namespace graspdb
