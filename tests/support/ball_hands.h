// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "graspdb/core/descriptor.h"
#include "graspdb/core/random.h"

namespace graspdb::testing {

// Descriptors for tests and benchmarks of searching, hard in the way that real ones are: gradient
// histograms of a crude hand of balls that closes on a ball, drawn 64 x 64. Rows come in families
// (grasps) of five steps, each seen from 648 sides. Everything is a pure function of the number.
class BallHands {
 public:
  static constexpr std::uint64_t kViews = 648;
  static constexpr std::uint64_t kSteps = 5;

  // A row as a database holds it.
  static Descriptor row(std::uint64_t i) {
    RandomStream view(1, i);
    const std::uint64_t pose = i / kViews;
    return describe(draw(
        balls(pose / kSteps, 0.2 * (1.0 + static_cast<double>(pose % kSteps)), view), view, 0));
  }
  // A view between the rows of the first `grasps` grasps, with flaws in its mask.
  static Descriptor query(std::uint64_t i, std::uint64_t grasps) {
    RandomStream view(2, i);
    const std::uint64_t grasp = view.below(grasps);
    const double closed = view.uniform(0.2, 1);
    return describe(draw(balls(grasp, closed, view), view, 0.005));
  }

 private:
  static constexpr int kSize = 64;
  struct Ball {
    Eigen::Vector3d center;  // pixels
    double radius;
    bool hand;  // else the object, which hides the hand
  };
  using Picture = std::array<float, std::size_t{kSize} * kSize>;  // 0 where there is no hand

  static void add_finger(std::vector<Ball>& balls, Eigen::Vector3d joint, double spread,
                         double bend, double length, RandomStream& grasp) {
    double flexion = 0;
    for (int bone = 0; bone < 3; ++bone) {
      flexion += bend * grasp.uniform(0.3, 1.6);
      const Eigen::Vector3d along(std::sin(spread) * std::cos(flexion),
                                  std::cos(spread) * std::cos(flexion), -std::sin(flexion));
      for (int i = 0; i < 6; ++i) balls.push_back({joint + along * (length * i / 6), 2.8, true});
      joint += along * length;
      length *= 0.75;
    }
  }

  // The hand around the origin, turned as the view says.
  static std::vector<Ball> balls(std::uint64_t grasp_number, double closed, RandomStream& view) {
    RandomStream grasp(3, grasp_number);
    std::vector<Ball> balls;
    for (int f = 0; f < 4; ++f) {
      const double x = -7.5 + 5.0 * f;
      for (int i = 0; i < 8; ++i) {
        balls.push_back({{x * (0.6 + 0.06 * i), -16.0 + 2.5 * i, 0}, 3.6, true});
      }
      add_finger(balls, {x, 2, 0}, 0.06 * (f - 1.5), closed * grasp.uniform(0.1, 1), 9, grasp);
    }
    add_finger(balls, {-8, -12, -1}, -0.9 + 0.8 * closed * grasp.uniform(),
               closed * grasp.uniform(), 10, grasp);
    const double radius = grasp.uniform(3, 11);
    balls.push_back({{grasp.uniform(-6, 6), grasp.uniform(0, 12), -3 - radius}, radius, false});
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(view.normal(), view.normal(), view.normal(), view.normal()).normalized();
    for (Ball& ball : balls) ball.center = turn * ball.center;
    return balls;
  }

  static std::size_t index(int x, int y) {
    return static_cast<std::size_t>(y) * kSize + static_cast<std::size_t>(x);
  }

  // Brightness is how much the surface faces the viewer. A share of the pixels is dropped.
  static Picture draw(const std::vector<Ball>& balls, RandomStream& noise, double dropped) {
    Picture picture{};
    std::array<double, std::size_t{kSize} * kSize> depth;
    depth.fill(-1e9);
    for (const Ball& ball : balls) {
      const auto [u, v] = std::pair(ball.center.x() + kSize / 2.0, ball.center.y() + kSize / 2.0);
      const int reach = static_cast<int>(ball.radius) + 1;
      for (int y = std::max(0, int(v) - reach); y <= std::min(kSize - 1, int(v) + reach); ++y) {
        for (int x = std::max(0, int(u) - reach); x <= std::min(kSize - 1, int(u) + reach); ++x) {
          const double left = ball.radius * ball.radius - (x - u) * (x - u) - (y - v) * (y - v);
          if (left <= 0) continue;
          const std::size_t at = index(x, y);
          if (ball.center.z() + std::sqrt(left) <= depth[at]) continue;
          depth[at] = ball.center.z() + std::sqrt(left);
          picture[at] =
              ball.hand ? static_cast<float>(0.3 + 0.7 * std::sqrt(left) / ball.radius) : 0;
        }
      }
    }
    for (float& pixel : picture) {
      if (dropped > 0 && noise.uniform() < dropped) pixel = 0;
    }
    return picture;
  }

  static Descriptor describe(const Picture& picture) {
    int low_x = kSize, low_y = kSize, high_x = 0, high_y = 0;
    for (int i = 0; i < kSize * kSize; ++i) {
      if (picture[static_cast<std::size_t>(i)] == 0) continue;
      low_x = std::min(low_x, i % kSize), high_x = std::max(high_x, i % kSize);
      low_y = std::min(low_y, i / kSize), high_y = std::max(high_y, i / kSize);
    }
    std::array<double, kDescriptorSize> votes{};
    std::array<double, 64> pixels{}, hand{}, sum{};
    const auto pixel = [&](int x, int y) {
      const bool inside = x >= 0 && y >= 0 && x < kSize && y < kSize;
      return inside ? picture[index(x, y)] : 0.0F;
    };
    for (int y = low_y; y <= high_y; ++y) {
      for (int x = low_x; x <= high_x; ++x) {
        const int row = (y - low_y) * 8 / (high_y - low_y + 1);
        const int column = (x - low_x) * 8 / (high_x - low_x + 1);
        const std::size_t cell =
            static_cast<std::size_t>(row) * 8 + static_cast<std::size_t>(column);
        pixels[cell] += 1;
        if (pixel(x, y) == 0) continue;
        const double dx = pixel(x + 1, y) - pixel(x - 1, y), dy = pixel(x, y + 1) - pixel(x, y - 1);
        const int bin = static_cast<int>((std::atan2(dy, dx) / 3.14159265 + 1) * 8) % 8;
        votes[cell * 8 + static_cast<std::size_t>(bin)] += std::hypot(dx, dy);
        hand[cell] += 1;
        sum[cell] += std::hypot(dx, dy);
      }
    }
    Descriptor descriptor;
    for (std::size_t i = 0; i < votes.size(); ++i) {
      const std::size_t cell = i / 8;
      const double share = hand[cell] / std::max(pixels[cell], 1.0);
      descriptor[i] = static_cast<std::uint8_t>(
          std::lround(255 * share * votes[i] / std::max(sum[cell], 1e-9)));
    }
    return descriptor;
  }
};

}  // namespace graspdb::testing
