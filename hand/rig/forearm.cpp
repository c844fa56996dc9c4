// SPDX-License-Identifier: MIT
#include "forearm.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "graspdb/core/error.h"
#include "graspdb/geometry/topology.h"
#include "graspdb/geometry/triangle.h"
#include "rim.h"
#include "subdivide.h"

namespace graspdb {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kCapCosine = .5;  // a cap's triangles face the elbow within 60 degrees
constexpr double kWideningShare =
    .075;  // of its length an arm's radius grows; about as in our hands
constexpr double kRingSpacingM = .006;
constexpr double kLongestEdgeM = .005;  // round the end that is extended

// What follows each vertex along the open edges.
std::map<std::uint32_t, std::uint32_t> open_edges(const std::vector<Triangle>& triangles) {
  std::map<std::uint32_t, std::uint32_t> next;
  for_each_edge(triangles, [&](Edge edge) {
    const auto upwards = std::count_if(edge.begin(), edge.end(),
                                       [](const TriangleSide& side) { return side.upwards; });
    if (upwards == 0) next.emplace(edge.front().high, edge.front().low);
    if (upwards == std::ssize(edge)) next.emplace(edge.front().low, edge.front().high);
  });
  return next;
}

Vector3d face_normal(const Mesh& mesh, const Triangle& t) {
  return normal_of(corners_of(mesh, t));
}

// The triangles that face the elbow and hang together with the vertex nearest to it.
std::vector<bool> cap_of(const Mesh& mesh, const Vector3d& elbow) {
  std::size_t last = 0;
  std::vector<bool> faces_elbow(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    faces_elbow[i] = face_normal(mesh, mesh.triangles[i]).normalized().dot(elbow) > kCapCosine;
  }
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const auto beyond = [&](std::size_t u) { return mesh.vertices[u].cast<double>().dot(elbow); };
    if (beyond(v) > beyond(last)) last = v;
  }
  std::vector<bool> touched(mesh.vertices.size()), cap(mesh.triangles.size());
  touched[last] = true;
  for (bool grows = true; grows;) {
    grows = false;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const Triangle& t = mesh.triangles[i];
      if (cap[i] || !faces_elbow[i] || !(touched[t[0]] || touched[t[1]] || touched[t[2]])) continue;
      cap[i] = grows = touched[t[0]] = touched[t[1]] = touched[t[2]] = true;
    }
  }
  return cap;
}

void remove_triangles(const std::vector<bool>& removed, std::vector<Triangle>& triangles) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (!removed[i]) triangles[kept++] = triangles[i];
  }
  triangles.resize(kept);
}

void remove_unused_vertices(RigSkin& skin) {
  std::vector<std::uint32_t> renamed(skin.mesh.vertices.size(), 0);
  for (const Triangle& t : skin.mesh.triangles) {
    for (const std::uint32_t v : t) renamed[v] = 1;
  }
  std::uint32_t kept = 0;
  for (std::size_t v = 0; v < renamed.size(); ++v) {
    if (renamed[v] == 0) continue;
    skin.mesh.vertices[kept] = skin.mesh.vertices[v];
    skin.mesh.normals[kept] = skin.mesh.normals[v];
    skin.mesh.albedo[kept] = skin.mesh.albedo[v];
    skin.weights[kept] = skin.weights[v];
    renamed[v] = kept++;
  }
  skin.mesh.vertices.resize(kept);
  skin.mesh.normals.resize(kept);
  skin.mesh.albedo.resize(kept);
  skin.weights.resize(kept);
  for (Triangle& t : skin.mesh.triangles) {
    for (std::uint32_t& v : t) v = renamed[v];
  }
}

// The means of the normals of the triangles round each of some vertices, by area.
void smooth_normals(const std::vector<std::uint32_t>& vertices, Mesh& mesh) {
  std::vector<Vector3d> sums(mesh.vertices.size(), Vector3d::Zero());
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) sums[v] += face_normal(mesh, t);
  }
  for (const std::uint32_t v : vertices) mesh.normals[v] = sums[v].normalized().cast<float>();
}

// The open edges as one ring of vertices; empty when they are not one.
std::vector<std::uint32_t> single_loop(const std::map<std::uint32_t, std::uint32_t>& next) {
  std::vector<std::uint32_t> loop;
  if (next.empty()) return loop;
  const std::uint32_t first = next.begin()->first;
  std::uint32_t v = first;
  do {
    loop.push_back(v);
    const auto step = next.find(v);
    if (step == next.end() || loop.size() > next.size()) return {};
    v = step->second;
  } while (v != first);
  return loop.size() == next.size() ? loop : std::vector<std::uint32_t>{};
}

// Halves the loop's edges until none is long, each with the one triangle that it belongs to.
std::vector<std::uint32_t> refine(const std::vector<std::uint32_t>& loop, RigSkin& skin) {
  std::vector<std::uint32_t> fine;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const std::uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
    fine.push_back(a);
    if (!((skin.mesh.vertices[a] - skin.mesh.vertices[b]).norm() > kLongestEdgeM)) continue;
    const std::uint32_t middle = add_midpoint(a, b, skin);
    fine.push_back(middle);
    for (std::size_t t = 0; t < skin.mesh.triangles.size(); ++t) {
      Triangle& whole = skin.mesh.triangles[t];
      const auto from =
          static_cast<std::size_t>(std::find(whole.begin(), whole.end(), a) - whole.begin());
      if (from == 3 || whole[(from + 1) % 3] != b) continue;
      const Triangle half = {middle, b, whole[(from + 2) % 3]};
      whole[(from + 1) % 3] = middle;
      skin.mesh.triangles.push_back(half);
      break;
    }
  }
  return fine.size() == loop.size() ? fine : refine(fine, skin);
}

// Grows rings from a loop towards the elbow.
class Extension {
 public:
  Extension(std::vector<std::uint32_t> loop, const Vector3d& elbow, double length, RigSkin& skin)
      : loop_(std::move(loop)),
        elbow_(elbow),
        length_(length),
        skin_(skin),
        rim_(loop_, elbow, skin.mesh) {}

  void build() {
    const int rings = std::max(1, static_cast<int>(std::lround(length_ / kRingSpacingM)));
    std::vector<std::uint32_t> ring = loop_;
    for (int i = 1; i <= rings; ++i) ring = add_ring(ring, static_cast<double>(i) / rings);
    std::vector<std::uint32_t> renewed = loop_;
    for (std::size_t v = old_vertices_; v < skin_.mesh.vertices.size(); ++v) {
      renewed.push_back(static_cast<std::uint32_t>(v));
    }
    smooth_normals(renewed, skin_.mesh);
    close(ring);
  }

 private:
  static std::uint32_t following(const std::vector<std::uint32_t>& ring, std::size_t i) {
    return ring[(i + 1) % ring.size()];
  }

  Vector3d place(std::uint32_t v) const { return skin_.mesh.vertices[v].cast<double>(); }

  std::uint32_t add_vertex(const Vector3d& position, std::uint32_t like) {
    skin_.mesh.vertices.push_back(position.cast<float>());
    skin_.mesh.normals.push_back(elbow_.cast<float>());
    skin_.mesh.albedo.push_back(skin_.mesh.albedo[like]);
    skin_.weights.push_back(PerBone<double>(skin_.weights[like]));
    return static_cast<std::uint32_t>(skin_.mesh.vertices.size() - 1);
  }

  // The loop may lie aslant: by the last ring it stands straight.
  std::vector<std::uint32_t> add_ring(const std::vector<std::uint32_t>& before, double progress) {
    const double width = 1 + kWideningShare * length_ * progress / rim_.radius();
    std::vector<std::uint32_t> ring;
    for (const std::uint32_t v : loop_) {
      const double slant = elbow_.dot(place(v) - rim_.center());
      const double beyond = slant + (length_ - slant) * progress;
      ring.push_back(
          add_vertex(rim_.center() + rim_.across(place(v)) * width + elbow_ * beyond, v));
    }
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::uint32_t next_before = following(before, i), next = following(ring, i);
      skin_.mesh.triangles.push_back({next_before, before[i], ring[i]});
      skin_.mesh.triangles.push_back({next_before, ring[i], next});
    }
    return ring;
  }

  void close(const std::vector<std::uint32_t>& ring) {
    const std::uint32_t center = add_vertex(rim_.center() + elbow_ * length_, ring.front());
    for (std::size_t i = 0; i < ring.size(); ++i) {
      skin_.mesh.triangles.push_back({following(ring, i), ring[i], center});
    }
  }

  std::vector<std::uint32_t> loop_;
  Vector3d elbow_;
  double length_;
  RigSkin& skin_;
  Rim rim_;
  std::size_t old_vertices_ = skin_.mesh.vertices.size();
};

}  // namespace

std::optional<std::string> open_end(const Vector3d& elbow, RigSkin& skin) {
  std::vector<Triangle> triangles = skin.mesh.triangles;
  if (open_edges(triangles).empty()) remove_triangles(cap_of(skin.mesh, elbow), triangles);
  const auto edges = open_edges(triangles);
  const std::vector<std::uint32_t> loop = single_loop(edges);
  if (loop.empty()) return fmt::format("{} open edges that are not", edges.size());
  if (auto fault = fault_of_rim(loop, elbow, triangles, skin)) return fault;
  skin.mesh.triangles = std::move(triangles);
  smooth_normals(loop, skin.mesh);  // they leant over the cap
  remove_unused_vertices(skin);
  return std::nullopt;
}

void extend_forearm(double length, const Vector3d& elbow, RigSkin& skin) {
  const std::vector<std::uint32_t> loop = single_loop(open_edges(skin.mesh.triangles));
  GRASPDB_CHECK(!loop.empty());
  Extension(refine(loop, skin), elbow, length, skin).build();
}

void split_forearm(const ForearmSplit& split, const Vector3d& elbow, RigSkin& skin) {
  for (std::size_t v = 0; v < skin.weights.size(); ++v) {
    const double beyond = skin.mesh.vertices[v].cast<double>().dot(elbow);
    const double t = std::clamp((beyond - split.at) / split.width + .5, 0., 1.);
    const double share = t * t * (3 - 2 * t);
    for (double& weight : skin.weights[v]) weight *= 1 - share;
    skin.weights[v][kForearm] += share;
  }
}

}  // namespace graspdb
