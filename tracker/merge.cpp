// SPDX-License-Identifier: MIT
#include "merge.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <span>

#include "candidate.h"
#include "column_products.h"
#include "graspdb/core/transform.h"

namespace graspdb {
namespace {

// Bytes: codes that differ by less say little of the pose. The best for hand.safetensors.
constexpr float kCodeRidge = 5;

// Rows of less weight, as a share of the heaviest one's, are left out: they take time, and hardly
// move the answer.
constexpr double kLightest = 1e-3;

// Such that the mean of two places looks half way between them.
Eigen::RowVector3d place_of(const Eigen::Vector3d& palm_center) {
  const double z = palm_center.z();
  return {palm_center.x() / z, palm_center.y() / z, std::log(z)};
}

Eigen::Vector3d palm_center_at(const Eigen::RowVector3d& place) {
  return Eigen::Vector3d(place.x(), place.y(), 1) * std::exp(place.z());
}

// The code of a row less what was seen.
Eigen::RowVectorXf difference(DescriptorView row, DescriptorView seen) {
  using Bytes = Eigen::Map<const Eigen::Matrix<std::uint8_t, 1, Eigen::Dynamic>>;
  const auto view = [](DescriptorView bytes) {
    return Bytes(bytes.data(), static_cast<Eigen::Index>(bytes.size())).cast<float>();
  };
  return view(row) - view(seen);
}

template <typename Lines>
auto numbers_of(Lines& lines) {
  return std::span(lines.data(), static_cast<std::size_t>(lines.size()));
}

}  // namespace

PoseLine fitted_pose(const PoseLines& poses, const CodeLines& codes, const LineWeights& weights) {
  const PoseLine mean_pose = weights.transpose() * poses;
  const Eigen::RowVectorXf mean_code = weights.transpose() * codes;
  const LineWeights roots = weights.cwiseSqrt();
  const CodeLines from_mean = roots.asDiagonal() * (codes.rowwise() - mean_code);
  const PoseLines turned = roots.asDiagonal() * (poses.rowwise() - mean_pose);
  CodeLines squares(codes.cols(), codes.cols());
  column_products(numbers_of(from_mean), static_cast<std::size_t>(codes.cols()),
                  numbers_of(squares));
  squares.diagonal().array() += kCodeRidge * kCodeRidge;
  // Only along the mean code is the slope of use: that is one equation to solve, not one a number.
  const Eigen::VectorXf along =
      squares.selfadjointView<Eigen::Lower>().llt().solve(mean_code.transpose());
  const PoseLine fitted = mean_pose - (from_mean * along).transpose() * turned;
  return fitted.cwiseMax(poses.colwise().minCoeff()).cwiseMin(poses.colwise().maxCoeff());
}

// The look that found it.
const Tracker::Look& Tracker::look_of(const Candidate& candidate, const std::vector<Look>& looks) {
  return *std::ranges::find(looks, candidate.roll_deg, &Look::roll_deg);
}

// The heaviest candidate with a pose between those that are not much lighter and turned no further
// than merge_deg from it: their mean by weight or, where rows have codes, what a line through them
// says.
Tracker::Candidate Tracker::merged(const std::vector<Candidate>& candidates,
                                   const std::vector<Look>& looks) const {
  Candidate best = candidates.front();
  if (options_.merge_deg == 0) return best;
  const DescriptorTable table = database_.descriptors();
  const bool has_codes = database_.has_embeddings();
  PoseLines poses(candidates.size(), PoseLine::ColsAtCompileTime);
  CodeLines codes(candidates.size(), has_codes ? table.size : 0);
  LineWeights weights(candidates.size());
  Eigen::Index count = 0;
  for (const Candidate& candidate : candidates) {  // the heaviest first
    if (candidate.weight < kLightest * best.weight) break;
    const Eigen::Matrix3d best_from_row = best.rotation.transpose() * candidate.rotation;
    const Eigen::Vector3d turn = vector_from_rotation(best_from_row);
    if (turn.norm() > radians(options_.merge_deg)) continue;
    poses.row(count) << turn.transpose().cast<float>(),
        place_of(candidate.placement.palm_center).cast<float>(),
        candidate.angles.transpose().cast<float>();
    if (has_codes)
      codes.row(count) = difference(table.row(candidate.row), look_of(candidate, looks).code);
    weights[count++] = static_cast<float>(candidate.weight);
  }
  poses.conservativeResize(count, Eigen::NoChange);
  codes.conservativeResize(count, Eigen::NoChange);
  weights.conservativeResize(count);
  weights /= weights.sum();
  const PoseLine pose =
      has_codes ? fitted_pose(poses, codes, weights) : PoseLine(weights.transpose() * poses);
  best.rotation *= rotation_from_vector(pose.head<3>().transpose().cast<double>());
  best.placement.palm_center = palm_center_at(pose.segment<3>(3).cast<double>());
  best.angles = pose.tail<kAngleCount>().transpose().cast<double>();
  best.pose = pose_vector(best.rotation, best.angles);
  return best;
}

}  // namespace graspdb
