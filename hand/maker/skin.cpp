// SPDX-License-Identifier: MIT
#include "skin.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "graspdb/core/parallel.h"
#include "graspdb/geometry/topology.h"

namespace graspdb {
namespace {

using Row = Eigen::Matrix<double, kBoneCount, 1>;
using Shares = Eigen::Array<double, 5, 1>;  // of the digits from thumb to little finger, sum 1

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
    {{kThumbMetacarpal, 21, -2}, {kThumbProximal, 17, 1}, {kThumbDistal, 13, 0}}};

std::array<Joint, 4> finger_joints(int finger) {
  return {{{finger_bone(finger, kMetacarpal), 20, 6},
           {finger_bone(finger, kProximal), 18, 2},
           {finger_bone(finger, kMiddle), 13, 0},
           {finger_bone(finger, kDistal), 11, 0}}};
}

class Weigher {
 public:
  Weigher(const HandSurface& surface, const BoneFramesMm& frames, double width)
      : surface_(surface), frames_(frames), width_(width) {}

  // Given how much of the skin there belongs to each digit.
  Row weights(const Eigen::Vector3d& point, const Shares& shares) const {
    Row weights = Row::Zero();
    for (int digit = 0; digit < 5; ++digit) add_chain(digit, point, shares[digit], weights);
    // 75 mm in all: at 30 mm 326 triangles turn over when the wrist bends by 80 degrees, here none.
    const double forearm = 1 - smooth_step(-42 * width_, 33 * width_, point.y());
    weights *= 1 - forearm;
    weights[kForearm] += forearm;
    return weights;
  }

  // The palm is divided softly, by the distance to the metacarpals; fingers sharply, so that a
  // finger never moves its neighbour. Most softly of all the first web between thumb and palm: when
  // the thumb is flexed into the palm by 50 degrees, 130 of 10,000 triangles there turn over with a
  // softness of 8 mm, 30 to 40 with this one.
  Shares shares(const Eigen::Vector3d& point) const {
    Shares share;
    double thumb_end = 1e9, finger = 1e9, palm = 1e9;
    for (int i = 0; i < 5; ++i) {
      const double phalanges =
          surface_.flesh().digits[static_cast<std::size_t>(i)].distance_to(point);
      const double metacarpal =
          distance_to(surface_.flesh().rays[static_cast<std::size_t>(i)], point);
      share[i] = std::min(phalanges, metacarpal);
      double& end = i == 0 ? thumb_end : finger;
      end = std::min(end, phalanges);
      palm = std::min(palm, metacarpal);
    }
    const double off_finger = smooth_step(-3, 6, finger - palm);
    const double softness = width_ * std::lerp(1.6, 8.0, off_finger);
    const double nearest = share.tail<4>().minCoeff();
    const double off_thumb = smooth_step(-26 * width_, -6 * width_, thumb_end - palm);
    const double web = width_ * std::lerp(4, 38, std::min(off_finger, off_thumb));
    const double thumb = smooth_step(-web, web, nearest - share[0]);
    share = ((nearest - share) / softness).exp();
    share *= (1 - thumb) / share.tail<4>().sum();
    share[0] = thumb;
    return share;
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

  const HandSurface& surface_;
  const BoneFramesMm& frames_;
  double width_;
};

void smooth(const RawMesh& mesh, int passes, std::vector<Shares>& shares) {
  const auto neighbors = vertex_neighbors(mesh.vertices.size(), mesh.triangles);
  for (int pass = 0; pass < passes; ++pass) {
    const std::vector<Shares> before = shares;
    for (std::size_t v = 0; v < shares.size(); ++v) {
      Shares sum = Shares::Zero();
      for (const std::uint32_t n : neighbors[v]) sum += before[n];
      shares[v] = .5 * before[v] + .5 / static_cast<double>(neighbors[v].size()) * sum;
    }
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
  std::vector<Shares> shares(mesh.vertices.size());
  parallel_for(shares.size(), 0,
               [&](std::size_t v) { shares[v] = weigher.shares(mesh.vertices[v]); });
  smooth(mesh, 18, shares);
  std::vector<SkinWeights> skins;
  for (std::size_t v = 0; v < shares.size(); ++v) {
    skins.push_back(four_largest(weigher.weights(mesh.vertices[v], shares[v])));
  }
  return skins;
}

}  // namespace graspdb
