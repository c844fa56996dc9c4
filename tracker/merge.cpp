// SPDX-License-Identifier: MIT
#include "merge.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "candidate.h"
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

// The codes of rows less what was seen.
CodeLines differences(const std::vector<std::uint32_t>& rows, const DescriptorTable& table,
                      DescriptorView query) {
  using Bytes = Eigen::Map<const Eigen::Matrix<std::uint8_t, 1, Eigen::Dynamic>>;
  const auto view = [](DescriptorView bytes) {
    return Bytes(bytes.data(), static_cast<Eigen::Index>(bytes.size())).cast<float>();
  };
  CodeLines codes(rows.size(), query.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    codes.row(static_cast<Eigen::Index>(i)) = view(table.row(rows[i])) - view(query);
  }
  return codes;
}

}  // namespace

PoseLine fitted_pose(const PoseLines& poses, const CodeLines& codes, const LineWeights& weights) {
  const PoseLine mean_pose = weights.transpose() * poses;
  const Eigen::RowVectorXf mean_code = weights.transpose() * codes;
  const LineWeights roots = weights.cwiseSqrt();
  const CodeLines from_mean = roots.asDiagonal() * (codes.rowwise() - mean_code);
  const PoseLines turned = roots.asDiagonal() * (poses.rowwise() - mean_pose);
  Eigen::MatrixXf squares = Eigen::MatrixXf::Zero(codes.cols(), codes.cols());
  squares.diagonal().fill(kCodeRidge * kCodeRidge);
  squares.selfadjointView<Eigen::Lower>().rankUpdate(from_mean.transpose());
  // Only along the mean code is the slope of use: that is one equation to solve, not one a number.
  const Eigen::VectorXf along =
      squares.selfadjointView<Eigen::Lower>().llt().solve(mean_code.transpose());
  const PoseLine fitted = mean_pose - (from_mean * along).transpose() * turned;
  return fitted.cwiseMax(poses.colwise().minCoeff()).cwiseMin(poses.colwise().maxCoeff());
}

// The heaviest candidate with a pose between those that are not much lighter and turned no further
// than merge_deg from it: their mean by weight or, where rows have codes, what a line through them
// says.
Tracker::Candidate Tracker::merged(const std::vector<Candidate>& candidates,
                                   DescriptorView query) const {
  Candidate best = candidates.front();
  if (options_.merge_deg == 0) return best;
  std::vector<std::uint32_t> rows;
  PoseLines poses(candidates.size(), PoseLine::ColsAtCompileTime);
  LineWeights weights(candidates.size());
  for (const Candidate& candidate : candidates) {  // the heaviest first
    if (candidate.weight < kLightest * best.weight) break;
    const Eigen::Matrix3d best_from_row = best.rotation.transpose() * candidate.rotation;
    const Eigen::Vector3d turn = vector_from_rotation(best_from_row);
    if (turn.norm() > radians(options_.merge_deg)) continue;
    const auto line = static_cast<Eigen::Index>(rows.size());
    poses.row(line) << turn.transpose().cast<float>(),
        place_of(candidate.placement.palm_center).cast<float>(),
        candidate.angles.transpose().cast<float>();
    weights[line] = static_cast<float>(candidate.weight);
    rows.push_back(candidate.row);
  }
  const auto count = static_cast<Eigen::Index>(rows.size());
  poses.conservativeResize(count, Eigen::NoChange);
  weights.conservativeResize(count);
  weights /= weights.sum();
  const PoseLine pose =
      database_.has_embeddings()
          ? fitted_pose(poses, differences(rows, database_.descriptors(), query), weights)
          : PoseLine(weights.transpose() * poses);
  best.rotation *= rotation_from_vector(pose.head<3>().transpose().cast<double>());
  best.placement.palm_center = palm_center_at(pose.segment<3>(3).cast<double>());
  best.angles = pose.tail<kAngleCount>().transpose().cast<double>();
  best.pose = pose_vector(best.rotation, best.angles);
  return best;
}

}  // namespace graspdb
