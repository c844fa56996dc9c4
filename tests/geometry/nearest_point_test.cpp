// SPDX-License-Identifier: MIT
#include "nearest_point.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "graspdb/core/random.h"

namespace graspdb {
namespace {

TEST(NearestPoint, IsThatOfBruteForce) {
  RandomStream random(3);
  const auto any = [&] {
    return Eigen::Vector3f(
        Eigen::Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-0.1, 0.1))
            .cast<float>());
  };
  for (const int count : {1, 2, 3, 100, 1000}) {
    std::vector<Eigen::Vector3f> points;
    for (int i = 0; i < count; ++i) points.push_back(i % 10 == 9 ? points.back() : any());
    const NearestPoint nearest(points);
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector3f to = 3 * any();
      float expected = 100;
      for (const Eigen::Vector3f& point : points)
        expected = std::min(expected, (point - to).norm());
      EXPECT_NEAR(nearest.distance(to.cast<double>()), expected, 1e-5);
    }
  }
}

}  // namespace
}  // namespace graspdb
