// SPDX-License-Identifier: MIT
// render(), which casts a ray through each pixel, is the oracle.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "graspdb/core/file.h"
#include "graspdb/generator/posed_scene.h"
#include "graspdb/generator/views.h"
#include "graspdb/grasps/closing.h"
#include "graspdb/hand/rig/rig.h"
#include "graspdb/renderer/renderer.h"
#include "renderer/shapes.h"
#include "renderer/straight_camera.h"
#include "support/instruction_sets.h"

namespace graspdb {
namespace {

using testing::capsule;
using testing::joined;
using testing::sphere;
using testing::straight_camera;

bool is_at_an_edge(const Image<std::uint8_t>& label, int x, int y) {
  for (int row = std::max(y - 1, 0); row <= std::min(y + 1, label.height() - 1); ++row) {
    for (int column = std::max(x - 1, 0); column <= std::min(x + 1, label.width() - 1); ++column) {
      if (label.at(column, row) != label.at(x, y)) return true;
    }
  }
  return false;
}

struct Disagreement {
  int pixels = 0;
  int label = 0;
  int label_inside = 0;  // of those, not at an edge of what rays see
  int shading = 0;       // by more than one level

  void add(const View& rays, const View& raster) {
    for (int y = 0; y < rays.label.height(); ++y) {
      for (int x = 0; x < rays.label.width(); ++x) {
        ++pixels;
        const bool other = rays.label.at(x, y) != raster.label.at(x, y);
        label += other;
        label_inside += other && !is_at_an_edge(rays.label, x, y);
        shading += std::abs(rays.shading.at(x, y) - raster.shading.at(x, y)) > 1;
      }
    }
  }
};

void expect_the_same_picture(const Scene& scene, const Camera& camera, const Light& light = {}) {
  Disagreement seen;
  seen.add(render(scene, camera, light), rasterize(scene, camera, light));
  EXPECT_EQ(seen.label_inside, 0);
  EXPECT_LE(seen.label, 1);
  EXPECT_LE(seen.shading, 1);
}

TEST(Rasterize, DrawsGraspsAsRaysSeeThem) {
  const Hand hand =
      with_visible_forearm(load_hand(data_directory() / "assets/hands/male.glb"), 0.015);
  const JointAngles rest = load_rest_pose(data_directory() / "grasps");
  const std::vector<Eigen::Matrix3d> views = view_rotations(24);
  Disagreement seen;
  for (const Grasp& grasp : load_grasps(data_directory() / "grasps")) {
    if (grasp.id % 6 != 1) continue;
    for (const int step : {2, 5}) {
      const GraspPose pose = pose_at_step(grasp, rest, closed_pose(grasp, hand), step, 5);
      const PosedScene posed = pose_scene(hand, pose, grasp.object.get());
      for (const Eigen::Matrix3d& view : views) {
        const Camera camera = crop_camera(view, posed.center, 0.7, posed.hand_vertices, 128);
        seen.add(render(posed.scene, camera), rasterize(posed.scene, camera));
      }
    }
  }
  EXPECT_GT(seen.pixels, 4'000'000);
  EXPECT_LE(seen.label, 5e-6 * seen.pixels);
  EXPECT_EQ(seen.label_inside, 0);
  EXPECT_LE(seen.shading, 5e-4 * seen.pixels);
}

TEST(Rasterize, DrawsPicturesOfAnySize) {
  const Mesh object = sphere({0.05, 0.02, 0.6}, 0.04);
  const Scene scene(capsule({0, 0, 0.7}, 0.04, 0.1), {}, &object);
  for (const auto& [width, height] : {std::pair(1, 1), {2, 5}, {3, 3}, {131, 126}, {640, 77}}) {
    expect_the_same_picture(scene, straight_camera(width, height, 3.0 * height));
  }
}

TEST(Rasterize, LightsAsRaysDo) {
  const Scene scene(sphere({0, 0, 0.7}, 0.1), {}, nullptr);
  for (const double softness : {0.0, 0.4, 1.0}) {
    const Light light{.softness = softness, .towards_light_in_camera = {-2, 1, -0.5}};
    expect_the_same_picture(scene, straight_camera(128, 128, 400), light);
  }
}

TEST(Rasterize, ShowsWhatIsBehindAGap) {
  const Mesh fingers =
      joined(capsule({-0.03, 0, 0.6}, 0.02, 0.08), capsule({0.03, 0, 0.6}, 0.02, 0.08));
  const Mesh object = sphere({0, 0, 0.8}, 0.06);
  const Scene scene(fingers, {}, &object);
  const Camera camera = straight_camera(128, 128, 400);
  expect_the_same_picture(scene, camera);
  EXPECT_EQ(rasterize(scene, camera).label.at(64, 64), kObjectSurface);
}

// The corners of all its squares lie exactly in pixels' centres.
TEST(Rasterize, LeavesNoCrackBetweenTriangles) {
  constexpr int kSide = 48;
  constexpr float kPixel = 1.0F / 64;  // at a depth of one metre, and a focal length of 64
  Mesh plate;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      plate.vertices.emplace_back(static_cast<float>(x) * kPixel, static_cast<float>(y) * kPixel,
                                  1.0F);
      plate.normals.emplace_back(0.0F, 0.0F, -1.0F);
    }
  }
  for (std::uint32_t i = 0; i + kSide < plate.vertices.size(); ++i) {
    if (i % kSide == kSide - 1) continue;
    plate.triangles.push_back({i, i + kSide, i + 1});
    plate.triangles.push_back({i + 1, i + kSide, i + kSide + 1});
  }
  Camera camera;
  camera.intrinsics = {kSide, kSide, 64, 64, 0, 0};
  const View view = rasterize(Scene(plate, {}, nullptr), camera);
  EXPECT_EQ(std::count(view.label.begin(), view.label.end(), kHandSurface), kSide * kSide);
}

TEST(Rasterize, DrawsTrianglesThatSkinningHasTurnedOver) {
  Mesh skin = sphere({0, 0, 0.7}, 0.1);
  for (std::size_t t = 0; t < skin.triangles.size(); t += 7) {
    std::swap(skin.triangles[t][0], skin.triangles[t][1]);
  }
  expect_the_same_picture(Scene(skin, {}, nullptr), straight_camera(128, 128, 400));
}

TEST(Rasterize, WhatReachesTheCameraIsSeenAsByRays) {
  const Mesh hand = sphere({0, 0, 0.7}, 0.1);
  const Camera camera = straight_camera(96, 96, 80);
  for (const double depth : {0.095, 0.06, 0.0, -0.06}) {  // before, across, around and behind it
    const Mesh object = capsule({0.03, 0, depth}, 0.08, 0.2);
    expect_the_same_picture(Scene(hand, {}, &object), camera);
  }
}

class RasterizeWith : public testing::InstructionSet {};
INSTANTIATE_TEST_SUITE_P(Each, RasterizeWith, testing::each_instruction_set(),
                         testing::instruction_set_name);

TEST_P(RasterizeWith, GivesTheSameBytes) {
  const Mesh hand = joined(capsule({-0.03, 0, 0}, 0.02, 0.08), sphere({0.03, 0, 0}, 0.06, 50));
  const Mesh object = sphere({0, 0.05, 0.04}, 0.04, 20);
  const Scene scene(hand, {}, &object, std::vector<float>(hand.vertices.size(), 0.7F));
  const auto draw = [&](const Eigen::Matrix3d& view) {
    return rasterize(scene, crop_camera(view, {0.01, 0, 0}, 0.7, hand.vertices, 101));
  };
  for (const Eigen::Matrix3d& rotation : view_rotations(10)) {
    const View here = draw(rotation);
    use_best();
    const View best = draw(rotation);
    use_param();
    EXPECT_EQ(here.shading, best.shading);
    EXPECT_EQ(here.label, best.label);
  }
}

}  // namespace
}  // namespace graspdb
