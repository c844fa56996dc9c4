// SPDX-License-Identifier: MIT
// The table of docs/views.md: how far random rotations are from the nearest of a set of views.
#include <fmt/format.h>

#include "graspdb/generator/views.h"
#include "support/nearest_views.h"

namespace graspdb {
namespace {

constexpr int kSamples = 200'000;
using Rotations = std::vector<Eigen::Matrix3d>;

Eigen::Matrix3d rotation(const Eigen::RowVector4d& q) {
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
}

// Alexa, "Super-Fibonacci Spirals", CVPR 2022; `shift` is a half in the paper.
Rotations super_fibonacci(int count, double shift, double psi = 1.533751168755204288118041) {
  Rotations rotations;
  for (int i = 0; i < count; ++i) {
    const double s = i + shift, r = std::sqrt(s / count), complement = std::sqrt(1 - s / count);
    const double alpha = 2 * kPi * s / std::sqrt(2.0), beta = 2 * kPi * s / psi;
    rotations.push_back(rotation({complement * std::cos(beta), r * std::sin(alpha),
                                  r * std::cos(alpha), complement * std::sin(beta)}));
  }
  return rotations;
}

Rotations random_rotations(int count) {
  Rotations rotations;
  RandomStream random(2);
  for (int i = 0; i < count; ++i) rotations.push_back(rotation(testing::random_quaternion(random)));
  return rotations;
}

Rotations random_subset(Rotations of, std::size_t count) {
  RandomStream random(3);
  for (std::size_t i = 0; i < count; ++i) std::swap(of[i], of[i + random.below(of.size() - i)]);
  of.resize(count);
  return of;
}

// Lloyd's relaxation: each view moves to the mean of the random rotations that are nearest to it.
Rotations relaxed(const Rotations& start, int rounds) {
  testing::Quaternions set = testing::quaternions(start);
  RandomStream random(4);
  for (int round = 0; round < rounds; ++round) {
    Eigen::MatrixX4d sums = Eigen::MatrixX4d::Zero(set.rows(), 4);
    for (Eigen::Index i = 0; i < 100 * set.rows(); ++i) {
      const Eigen::RowVector4d q = testing::random_quaternion(random);
      const Eigen::VectorXf cosines = set * q.cast<float>().transpose();
      Eigen::Index nearest = 0;
      cosines.cwiseAbs().maxCoeff(&nearest);
      sums.row(nearest) += cosines[nearest] < 0 ? -q : q;
    }
    set = sums.rowwise().normalized().cast<float>();
  }
  Rotations rotations;
  for (Eigen::Index i = 0; i < set.rows(); ++i)
    rotations.push_back(rotation(set.row(i).cast<double>()));
  return rotations;
}

void print(const char* name, const Rotations& rotations) {
  const testing::NearestAngles nearest = testing::nearest_angles(rotations, kSamples);
  fmt::print("| {} | {} | {:.2f} | {:.1f} | {:.1f} |\n", rotations.size(), name, nearest.mean_deg,
             nearest.p95_deg, nearest.max_deg);
  std::fflush(stdout);
}

void print_all(int count) {
  print("ours", view_rotations(count));
  print("super-Fibonacci", super_fibonacci(count, 0.5));
  print("random rotations", random_rotations(count));
}

}  // namespace
}  // namespace graspdb

int main() {
  using namespace graspdb;
  fmt::print("| N | set | mean | p95 | max |\n| --- | --- | --- | --- | --- |\n");
  for (const int count : {162, 648, 2592}) print_all(count);
  print("super-Fibonacci from 0.25", super_fibonacci(648, 0.25));
  print("super-Fibonacci from 0.75", super_fibonacci(648, 0.75));
  print("super-Fibonacci, golden ratio for psi",
        super_fibonacci(648, .5, (1 + std::sqrt(5.0)) / 2));
  for (const int directions : {36, 72, 108, 162})
    print(fmt::format("{} directions", directions).c_str(), rolled_directions(directions, 648));
  print("random of our 2592", random_subset(view_rotations(2592), 648));
  print("ours, relaxed 60 times", relaxed(view_rotations(648), 60));
}
