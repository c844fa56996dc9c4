// SPDX-License-Identifier: MIT
#include "mesher.h"

#include <array>
#include <cmath>
#include <utility>

#include "graspdb/core/error.h"
#include "graspdb/core/parallel.h"
#include "graspdb/geometry/topology.h"

namespace graspdb {
namespace {

constexpr int kBlock = 4;  // cells a side that are decided together
constexpr std::uint32_t kNone = ~0u;

// Surface nets (Gibson 1998): a vertex in every cell that the surface crosses, a quad across every
// grid edge that it crosses.
class SurfaceNets {
 public:
  SurfaceNets(const HandSurface& surface, double cell, double shift)
      : surface_(surface), cell_(cell) {
    origin_ = surface.bounds().min().array() - (1 + shift) * cell;
    const Eigen::Vector3d cells = (surface.bounds().max() - origin_) / cell;
    for (int axis = 0; axis < 3; ++axis) {
      size_[axis] = (static_cast<int>(std::ceil(cells[axis])) / kBlock + 1) * kBlock + 1;
    }
    values_.resize(index({0, 0, size_[2]}));
  }

  RawMesh make() {
    sample();
    vertex_of_cell_.assign(values_.size(), kNone);
    for_each_cell([&](const Eigen::Vector3i& cell) { add_vertex(cell); });
    for_each_cell([&](const Eigen::Vector3i& cell) { add_quads(cell); });
    return std::move(mesh_);
  }

 private:
  std::size_t index(const Eigen::Vector3i& p) const {
    return static_cast<std::size_t>(p[0]) +
           static_cast<std::size_t>(size_[0]) *
               (static_cast<std::size_t>(p[1]) +
                static_cast<std::size_t>(size_[1]) * static_cast<std::size_t>(p[2]));
  }
  Eigen::Vector3d position(const Eigen::Vector3d& grid) const { return origin_ + cell_ * grid; }
  bool inside(const Eigen::Vector3i& p) const { return values_[index(p)] < 0; }

  // Blocks that lie wholly on one side take the value of their centre.
  void sample() {
    const Eigen::Vector3i blocks = (size_.array() - 1) / kBlock + 1;
    parallel_for(static_cast<std::size_t>(blocks.prod()), 0, [&](std::size_t b) {
      const int i = static_cast<int>(b);
      sample_block(kBlock * Eigen::Vector3i(i % blocks[0], i / blocks[0] % blocks[1],
                                            i / (blocks[0] * blocks[1])));
    });
  }

  void sample_block(const Eigen::Vector3i& first) {
    const Eigen::Vector3d center = first.cast<double>().array() + .5 * (kBlock - 1);
    const double at_center = surface_.distance(position(center));
    // A corner is .87 of a side away; distances are only right to first order, hence a margin.
    const bool far = std::abs(at_center) > 1.3 * kBlock * cell_;
    const Eigen::Vector3i last = (first.array() + kBlock).min(size_.array());
    for (int z = first[2]; z < last[2]; ++z) {
      for (int y = first[1]; y < last[1]; ++y) {
        for (int x = first[0]; x < last[0]; ++x) {
          values_[index({x, y, z})] =
              far ? at_center : surface_.distance(position(Eigen::Vector3d(x, y, z)));
        }
      }
    }
  }

  template <typename Body>
  void for_each_cell(const Body& body) const {
    for (int z = 0; z + 1 < size_[2]; ++z) {
      for (int y = 0; y + 1 < size_[1]; ++y) {
        for (int x = 0; x + 1 < size_[0]; ++x) body(Eigen::Vector3i(x, y, z));
      }
    }
  }

  // The mean of the crossings on the cell's twelve edges.
  void add_vertex(const Eigen::Vector3i& cell) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    int crossings = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3i from = cell + Eigen::Vector3i(corner & 1, corner >> 1 & 1, corner >> 2);
      for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3i to = from + Eigen::Vector3i::Unit(axis);
        if ((corner >> axis & 1) != 0 || inside(from) == inside(to)) continue;
        const double a = values_[index(from)], b = values_[index(to)];
        sum += from.cast<double>() + a / (a - b) * Eigen::Vector3d::Unit(axis);
        ++crossings;
      }
    }
    if (crossings == 0) return;
    vertex_of_cell_[index(cell)] = static_cast<std::uint32_t>(mesh_.vertices.size());
    mesh_.vertices.push_back(position(sum / crossings));
  }

  void add_quads(const Eigen::Vector3i& from) {
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3i u = Eigen::Vector3i::Unit((axis + 1) % 3),
                            v = Eigen::Vector3i::Unit((axis + 2) % 3);
      const Eigen::Vector3i to = from + Eigen::Vector3i::Unit(axis);
      if (inside(from) == inside(to)) continue;
      std::array<std::uint32_t, 4> quad{};
      const Eigen::Vector3i cells[] = {from, from - u, from - u - v, from - v};
      for (std::size_t i = 0; i < 4; ++i) quad[i] = vertex_of_cell_[index(cells[i])];
      if (!inside(from)) std::swap(quad[1], quad[3]);
      add_quad(quad);
    }
  }

  // Cut along the shorter diagonal.
  void add_quad(const std::array<std::uint32_t, 4>& q) {
    const auto length = [&](std::size_t a, std::size_t b) {
      return (mesh_.vertices[q[a]] - mesh_.vertices[q[b]]).squaredNorm();
    };
    const std::size_t first = length(0, 2) <= length(1, 3) ? 0 : 1;
    mesh_.triangles.push_back({q[first], q[first + 1], q[first + 2]});
    mesh_.triangles.push_back({q[first], q[first + 2], q[(first + 3) % 4]});
  }

  const HandSurface& surface_;
  double cell_;
  Eigen::Vector3d origin_;
  Eigen::Vector3i size_;
  std::vector<double> values_;
  std::vector<std::uint32_t> vertex_of_cell_;
  RawMesh mesh_;
};

Eigen::Vector3d mean_of(const std::vector<Eigen::Vector3d>& points,
                        const std::vector<std::uint32_t>& chosen) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const std::uint32_t i : chosen) sum += points[i];
  return sum / static_cast<double>(chosen.size());
}

}  // namespace

RawMesh mesh_surface(const HandSurface& surface, double cell) {
  // A cell that the surface crosses twice gives an edge with four triangles; another grid may not.
  for (int attempt = 0; attempt < 8; ++attempt) {
    RawMesh mesh = SurfaceNets(surface, cell, attempt / 8.0).make();
    if (is_sphere_like(mesh.vertices.size(), mesh.triangles)) return mesh;
  }
  throw Error("the hand's surface is not of one piece without handles: fingers may touch");
}

void relax(const HandSurface& surface, int passes, RawMesh& mesh) {
  const auto neighbors = vertex_neighbors(mesh.vertices.size(), mesh.triangles);
  for (int pass = 0; pass < passes; ++pass) {
    const std::vector<Eigen::Vector3d> before = mesh.vertices;
    parallel_for(before.size(), 0, [&](std::size_t v) {
      const Eigen::Vector3d gradient = surface.gradient(before[v]);
      const Eigen::Vector3d normal = gradient.normalized();
      const Eigen::Vector3d step = .5 * (mean_of(before, neighbors[v]) - before[v]);
      mesh.vertices[v] = surface.projected(before[v] + step - step.dot(normal) * normal, gradient);
    });
  }
}

}  // namespace graspdb
