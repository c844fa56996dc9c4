// SPDX-License-Identifier: MIT
#include "surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "graspdb/geometry/topology.h"
#include "graspdb/geometry/triangle.h"
#include "lines.h"

namespace graspdb {
namespace {

using Fan = std::vector<Triangle>;  // triangles round one vertex

bool share_an_edge(const Triangle& a, const Triangle& b) {
  return std::count_if(a.begin(), a.end(), [&](std::uint32_t v) {
           return std::find(b.begin(), b.end(), v) != b.end();
         }) >= 2;
}

// Whether one can walk round the vertex over all its triangles.
bool is_one_fan(Fan rest) {
  Fan reached = {rest.back()};
  rest.pop_back();
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const auto joined = std::partition(rest.begin(), rest.end(), [&](const Triangle& other) {
      return !share_an_edge(reached[i], other);
    });
    reached.insert(reached.end(), joined, rest.end());
    rest.erase(joined, rest.end());
  }
  return rest.empty();
}

struct VertexCounts {
  std::size_t used = 0, pinched = 0;
};

VertexCounts count_vertices(const Mesh& mesh) {
  std::vector<Fan> fans(mesh.vertices.size());
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) fans[v].push_back(t);
  }
  VertexCounts counts;
  for (const Fan& fan : fans) {
    if (fan.empty()) continue;
    ++counts.used;
    counts.pinched += !is_one_fan(fan);
  }
  return counts;
}

// Numbers of vertices that hang together, each named by one of them.
class Pieces {
 public:
  explicit Pieces(const Mesh& mesh) : above_(mesh.vertices.size()) {
    std::iota(above_.begin(), above_.end(), 0);
    for (const Triangle& t : mesh.triangles) {
      above_[of(t[1])] = of(t[0]);
      above_[of(t[2])] = of(t[0]);
    }
  }

  std::uint32_t of(std::uint32_t v) {
    while (above_[v] != v) v = above_[v] = above_[above_[v]];
    return v;
  }

 private:
  std::vector<std::uint32_t> above_;
};

// All pieces but the largest, each with a bone that moves it; empty when there is one.
std::string other_pieces(const Hand& hand) {
  Pieces pieces(hand.bind_mesh);
  std::map<std::uint32_t, std::size_t> sizes;
  for (const Triangle& t : hand.bind_mesh.triangles) ++sizes[pieces.of(t[0])];
  const auto largest = std::ranges::max_element(sizes, {}, [](const auto& p) { return p.second; });
  const std::vector<std::uint8_t> bones = strongest_bones(hand);
  std::string others;
  for (auto piece = sizes.begin(); piece != sizes.end(); ++piece) {
    if (piece == largest) continue;
    others += fmt::format("{}{} triangles on {}", others.empty() ? "apart: " : ", ", piece->second,
                          bone_name(bones[piece->first]));
  }
  return others;
}

// Tells the triangles at the forearm's end from all others.
class ForearmCap {
 public:
  explicit ForearmCap(const Hand& hand)
      : to_elbow_(-hand.hand_from_bone_at_bind[kForearm].rotation.col(1)) {
    for (const Eigen::Vector3f& v : hand.bind_mesh.vertices) {
      end_ = std::max(end_, to_elbow_.dot(v.cast<double>()));
    }
  }

  bool contains(const Corners& t) const {
    constexpr double kDepth = .003;
    const auto at_end = [&](const Eigen::Vector3d& v) { return to_elbow_.dot(v) > end_ - kDepth; };
    return at_end(t[0]) && at_end(t[1]) && at_end(t[2]);
  }

 private:
  Eigen::Vector3d to_elbow_;
  double end_ = -1e9;
};

void add_triangle_lines(const Hand& hand, std::vector<HandCheckLine>& lines) {
  const std::vector<std::uint8_t> bones = strongest_bones(hand);
  const ForearmCap cap(hand);
  Worst flattest{-1, {}}, longest;
  for (std::size_t i = 0; i < hand.bind_mesh.triangles.size(); ++i) {
    const Triangle& triangle = hand.bind_mesh.triangles[i];
    const Corners corners = corners_of(hand.bind_mesh, triangle);
    const auto place = [&] {
      return fmt::format("triangle {} on {}", i, bone_name(bones[triangle[0]]));
    };
    flattest.take(-quality_of(corners), place);
    if (!cap.contains(corners)) longest.take(longest_side(corners), place);
  }
  lines.push_back(judged("triangle quality", -flattest.value, "", at_least(.1), flattest.where));
  lines.push_back(judged("longest edge", 1000 * longest.value, "mm", at_most(12), longest.where));
}

}  // namespace

std::vector<HandCheckLine> check_surface(const Hand& hand) {
  const Mesh& mesh = hand.bind_mesh;
  const EdgeCounts edges = count_edges(mesh.triangles);
  const std::size_t open = edges.open + edges.crowded;
  const VertexCounts vertices = count_vertices(mesh);
  const auto number = [](std::size_t count) { return static_cast<double>(count); };
  std::vector<HandCheckLine> lines = {
      judged("open edges", number(open), "", exactly(0)),
      judged("pinched vertices", number(vertices.pinched), "", exactly(0)),
      judged("turned edges", number(edges.turned), "", exactly(0)),
      judged("Euler number",
             number(vertices.used) - number(edges.all) + number(mesh.triangles.size()), "",
             exactly(2), other_pieces(hand)),
      open == 0 ? judged("volume", 1e6 * volume_of(mesh), "cm3", above(0))
                : not_applicable("volume", "cm3", above(0), "the surface is open")};
  add_triangle_lines(hand, lines);
  return lines;
}

}  // namespace graspdb
