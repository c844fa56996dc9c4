// SPDX-License-Identifier: MIT
#include "skin.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "graspdb/parallel.h"

namespace graspdb {
namespace {

using Row = Eigen::Matrix<double, kBoneCount, 1>;

double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// One digit's bones from its metacarpal on, and how the skin passes from one to the next: the
// breadth in table millimetres over which a joint is blended, and how far distal its middle lies.
struct Joint {
  int bone;
  double half_width;
  double shift;
};
constexpr std::array<Joint, 3> kThumbJoints = {
    {{kThumbMetacarpal, 22, 0}, {kThumbProximal, 14, 1}, {kThumbDistal, 11, 0}}};

std::array<Joint, 4> finger_joints(int finger) {
  return {{{finger_bone(finger, kMetacarpal), 17, 6},
           {finger_bone(finger, kProximal), 15, 3},
           {finger_bone(finger, kMiddle), 10.5, 0},
           {finger_bone(finger, kDistal), 9, 0}}};
}

class Weigher {
 public:
  Weigher(const HandSurface& surface, const BoneFramesMm& frames, double width)
      : surface_(surface), frames_(frames), width_(width) {}

  Row weights(const Eigen::Vector3d& point) const {
    // 75 mm in all: at 30 mm 326 triangles turn over when the wrist bends by 80 degrees, here 8.
    const double forearm = 1 - smooth_step(-42 * width_, 33 * width_, point.y());
    Row weights = Row::Zero();
    const std::array<double, 5> share = digit_shares(point);
    for (int digit = 0; digit < 5; ++digit) {
      add_chain(digit, point, share[static_cast<std::size_t>(digit)], weights);
    }
    weights *= 1 - forearm;
    weights[kForearm] += forearm;
    return weights;
  }

 private:
  // How far beyond a joint's bisecting plane the point lies.
  double beyond(int bone, int parent, const Eigen::Vector3d& point) const {
    const RigidTransform& frame = frames_[static_cast<std::size_t>(bone)];
    const Eigen::Vector3d normal =
        (frame.rotation.col(1) + frames_[static_cast<std::size_t>(parent)].rotation.col(1))
            .normalized();
    return normal.dot(point - frame.translation);
  }

  template <std::size_t N>
  void add_joints(const std::array<Joint, N>& joints, const Eigen::Vector3d& point, double share,
                  Row& weights) const {
    int parent = kPalm;
    double left = share;
    for (const Joint& joint : joints) {
      const int axis_parent = parent == kPalm ? joint.bone : parent;
      const double past = beyond(joint.bone, axis_parent, point) - joint.shift * width_;
      const double passed =
          left * smooth_step(-joint.half_width * width_, joint.half_width * width_, past);
      weights[parent] += left - passed;
      left = passed;
      parent = joint.bone;
    }
    weights[parent] += left;
  }

  void add_chain(int digit, const Eigen::Vector3d& point, double share, Row& weights) const {
    if (digit == 0) {
      add_joints(kThumbJoints, point, share, weights);
    } else {
      add_joints(finger_joints(digit - 1), point, share, weights);
    }
  }

  // The palm is divided softly, by the distance to the metacarpals; fingers sharply, so that a
  // finger never moves its neighbour.
  std::array<double, 5> digit_shares(const Eigen::Vector3d& point) const {
    std::array<double, 5> distance{};
    double finger = 1e9, palm = 1e9;
    for (std::size_t i = 0; i < 5; ++i) {
      const double phalanges = distance_to(surface_.flesh().digits[i], point);
      const double metacarpal = distance_to(surface_.flesh().rays[i], point);
      distance[i] = std::min(phalanges, metacarpal);
      finger = std::min(finger, phalanges);
      palm = std::min(palm, metacarpal);
    }
    const double softness = width_ * std::lerp(1.6, 8.0, smooth_step(-3, 6, finger - palm));
    const double nearest = *std::min_element(distance.begin(), distance.end());
    for (double& d : distance) d = std::exp(-(d - nearest) / softness);
    const double sum = std::accumulate(distance.begin(), distance.end(), 0.0);
    for (double& d : distance) d /= sum;
    return distance;
  }

  const HandSurface& surface_;
  const BoneFramesMm& frames_;
  double width_;
};

void smooth(const RawMesh& mesh, int passes, std::vector<Row>& rows) {
  const auto neighbours = vertex_neighbours(mesh.vertices.size(), mesh.triangles);
  for (int pass = 0; pass < passes; ++pass) {
    const std::vector<Row> before = rows;
    parallel_for(rows.size(), 0, [&](std::size_t v) {
      Row sum = Row::Zero();
      for (const std::uint32_t n : neighbours[v]) sum += before[n];
      rows[v] = .5 * before[v] + .5 / static_cast<double>(neighbours[v].size()) * sum;
    });
  }
}

SkinWeights four_largest(const Row& row) {
  std::array<std::uint8_t, kBoneCount> order{};
  std::iota(order.begin(), order.end(), std::uint8_t{0});
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return row[a] > row[b]; });
  SkinWeights skin;
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) sum += row[order[i]] > 1e-3 ? row[order[i]] : 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (row[order[i]] <= 1e-3) break;
    skin.bone[i] = order[i];
    skin.weight[i] = static_cast<float>(row[order[i]] / sum);
  }
  return skin;
}

}  // namespace

std::vector<SkinWeights> skin_weights(const HandSurface& surface, const RawMesh& mesh,
                                      const BoneFramesMm& frames, double width) {
  const Weigher weigher(surface, frames, width);
  std::vector<Row> rows(mesh.vertices.size());
  parallel_for(rows.size(), 0, [&](std::size_t v) { rows[v] = weigher.weights(mesh.vertices[v]); });
  smooth(mesh, 12, rows);
  std::vector<SkinWeights> skins;
  skins.reserve(rows.size());
  for (const Row& row : rows) skins.push_back(four_largest(row));
  return skins;
}

}  // namespace graspdb
