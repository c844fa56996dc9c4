// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "graspdb/renderer/renderer.h"
#include "renderer/shapes.h"
#include "renderer/straight_camera.h"

namespace graspdb {
namespace {

using testing::capsule;
using ::testing::ElementsAre;
using testing::joined;
using testing::sphere;
using testing::straight_camera;

constexpr Layers kAllLayers{.depth = true, .normals = true, .parts = true, .amodal = true};

int count_of(const Image<std::uint8_t>& image, std::uint8_t value) {
  return static_cast<int>(std::count(image.begin(), image.end(), value));
}

TEST(Render, SphereHasItsDepthNormalsAndSilhouetteArea) {
  const double radius = 0.1, distance = 0.7, focal = 500;
  const Scene scene(sphere({0, 0, distance}, radius, 256), {}, nullptr);
  const View view = render(scene, straight_camera(201, 199, focal), {}, kAllLayers);

  EXPECT_NEAR(view.depth.at(100, 99), distance - radius, 1e-5);
  EXPECT_LT((view.normal.at(100, 99) - Eigen::Vector3f(0, 0, -1)).norm(), 1e-3);
  // The rays that touch the sphere make a cone; its section at z = 1 is a disc.
  const double disc = focal * radius / std::sqrt(distance * distance - radius * radius);
  EXPECT_NEAR(count_of(view.label, kHandSurface), kPi * disc * disc, 0.003 * kPi * disc * disc);
  EXPECT_EQ(count_of(view.part, 1), count_of(view.label, kHandSurface));
  EXPECT_TRUE(std::isinf(view.depth.at(0, 0)));
  EXPECT_EQ(view.shading.at(0, 0), 0);
}

TEST(Render, DepthIsPlanarAndNotTheDistance) {
  const double radius = 0.01;
  const Eigen::Vector3d center(0.2, -0.15, 0.5);
  const Camera camera = straight_camera(640, 480, 500);
  const View view = render(Scene(sphere(center, radius), {}, nullptr), camera, {}, kAllLayers);
  // The nearest point on the ray through the centre, found by hand.
  const Eigen::Vector3d front = center - radius * center.normalized();
  const Eigen::Vector2d pixel = camera.intrinsics.project(front);
  const auto x = static_cast<int>(std::lround(pixel.x()));
  const auto y = static_cast<int>(std::lround(pixel.y()));
  EXPECT_NEAR(view.depth.at(x, y), front.z(), 1e-4);
  EXPECT_GT(front.norm() - front.z(), 0.05);  // so that the two are told apart
}

TEST(Render, ASmallSphereIsSeenWhereTheCameraProjectsIt) {
  Camera camera = straight_camera(160, 120, 300);
  camera.intrinsics.fy = 280;
  camera.intrinsics.cx = 50.25;
  camera.camera_from_hand = {rotation_from_vector({0.4, -1.1, 0.3}), {0.03, -0.02, 0.6}};
  const Eigen::Vector3d center_in_hand(0.02, 0.05, -0.03);
  const View view = render(Scene(sphere(center_in_hand, 0.005), {}, nullptr), camera);
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) {
      if (view.label.at(x, y) == kHandSurface) sum += Eigen::Vector2d(x, y);
    }
  }
  const Eigen::Vector2d mean = sum / static_cast<double>(count_of(view.label, kHandSurface));
  const Eigen::Vector2d expected =
      camera.intrinsics.project(camera.camera_from_hand * center_in_hand);
  EXPECT_LT((mean - expected).norm(), 0.25);
}

TEST(Render, AnObjectInFrontMakesAHoleAndOneBehindDoesNot) {
  const Mesh hand = sphere({0, 0, 0.7}, 0.1);
  const Camera camera = straight_camera(128, 128, 300);
  for (const bool in_front : {true, false}) {
    const Mesh object = sphere({0, 0, in_front ? 0.5 : 0.9}, 0.02);
    const View view = render(Scene(hand, {}, &object), camera, {}, kAllLayers);
    EXPECT_EQ(view.label.at(64, 64), in_front ? kObjectSurface : kHandSurface);
    EXPECT_EQ(visible_hand(view).at(64, 64), in_front ? 0 : 255);
    EXPECT_EQ(view.part.at(64, 64), in_front ? 0 : 1);
    EXPECT_EQ(view.hand_amodal.at(64, 64), 255);
    EXPECT_EQ(view.object_amodal.at(64, 64), 255);
  }
}

TEST(Render, AmodalMasksHoldTheVisibleOnesAndWhatIsHidden) {
  const Mesh hand = sphere({0, 0, 0.7}, 0.1);
  const Mesh object = sphere({0.06, 0, 0.62}, 0.05);
  const Camera camera = straight_camera(131, 126, 400);  // not multiples of a tile
  const View view = render(Scene(hand, {}, &object), camera, {}, kAllLayers);
  const View hand_alone = render(Scene(hand, {}, nullptr), camera);
  const View object_alone = render(Scene(object, {}, nullptr), camera);
  EXPECT_EQ(view.hand_amodal, visible_hand(hand_alone));
  EXPECT_EQ(view.object_amodal, visible_hand(object_alone));
  EXPECT_LT(count_of(view.label, kHandSurface), count_of(view.hand_amodal, 255));
  for (std::size_t i = 0; i < view.label.size(); ++i) {
    if (view.label.data()[i] == kHandSurface) {
      EXPECT_EQ(view.hand_amodal.data()[i], 255);
    }
    if (view.label.data()[i] == kObjectSurface) {
      EXPECT_EQ(view.object_amodal.data()[i], 255);
    }
  }
}

TEST(Render, PartsFollowTheVertices) {
  const Mesh left = sphere({-0.05, 0, 0.7}, 0.03), right = sphere({0.05, 0, 0.7}, 0.03);
  std::vector<std::uint8_t> parts(left.vertices.size(), 4);
  parts.resize(left.vertices.size() + right.vertices.size(), 9);
  const View view = render(Scene(joined(left, right), parts, nullptr),
                           straight_camera(128, 128, 400), {}, kAllLayers);
  EXPECT_EQ(view.part.at(35, 64), 5);
  EXPECT_EQ(view.part.at(92, 64), 10);
  EXPECT_EQ(view.part.at(64, 64), 0);
}

TEST(Render, ShadingIsAmbientPlusLambertTimesAlbedo) {
  Mesh hand = sphere({0, 0, 0.7}, 0.1, 256);
  hand.albedo.assign(hand.vertices.size(), 0.5F);
  const std::vector<float> openness(hand.vertices.size(), 0.25F);
  const Camera camera = straight_camera(101, 101, 300);
  const Light light{.ambient = 0.4, .diffuse = 0.6, .towards_light_in_camera = {0, -2, -2}};
  const View view = render(Scene(hand, {}, nullptr, openness), camera, light, kAllLayers);
  for (const auto& [x, y] : {std::pair(50, 50), {50, 25}, {60, 80}, {30, 70}}) {
    const double cosine = std::max(
        0.0, view.normal.at(x, y).cast<double>().dot(Eigen::Vector3d(0, -1, -1).normalized()));
    EXPECT_NEAR(view.shading.at(x, y), 255 * 0.5 * (0.4 * 0.25 + 0.6 * cosine), 0.6)
        << x << ' ' << y;
  }
}

TEST(Render, ASoftLightReachesWhatIsTurnedAwayFromIt) {
  Mesh hand = sphere({0, 0, 0.7}, 0.1, 256);
  hand.albedo.assign(hand.vertices.size(), 0.5F);
  const Light light{
      .ambient = 0.1, .diffuse = 0.6, .softness = 0.5, .towards_light_in_camera = {0, -1, 0}};
  const View view =
      render(Scene(hand, {}, nullptr), straight_camera(101, 101, 300), light, kAllLayers);
  for (const auto& [x, y] : {std::pair(50, 50), {50, 25}, {60, 60}, {50, 85}}) {
    const double cosine = -view.normal.at(x, y).y();
    EXPECT_NEAR(view.shading.at(x, y), 255 * 0.5 * (0.1 + 0.6 * std::max(0.0, cosine + 0.5) / 1.5),
                0.6)
        << x << ' ' << y;
  }
  EXPECT_LT(-view.normal.at(60, 60).y(), 0);  // turned away, and lit
}

TEST(Render, TheLightIsFixedToTheCamera) {
  const Scene scene(sphere({0, 0, 0}, 0.1), {}, nullptr);
  const Light from_above{.towards_light_in_camera = {0, -1, -0.2}};
  for (const Eigen::Vector3d& turn : {Eigen::Vector3d(0, 0, 0), {1, 2, -1}, {-2, 0.3, 0.5}}) {
    Camera camera = straight_camera(64, 64, 150);
    camera.camera_from_hand = {rotation_from_vector(turn), {0, 0, 0.7}};
    const View view = render(scene, camera, from_above);
    EXPECT_GT(view.shading.at(32, 15), view.shading.at(32, 48) + 60);
  }
}

TEST(Render, TwoThreadsGiveTheSamePicture) {
  const Mesh object = sphere({0.05, 0, 0.6}, 0.05);
  const Scene scene(capsule({0, 0, 0.7}, 0.04, 0.1), {}, &object);
  const Camera camera = straight_camera(128, 128, 400);
  const View alone = render(scene, camera, {}, kAllLayers);
  std::vector<View> views(8);
  std::vector<std::jthread> threads;
  for (int t = 0; t < 2; ++t) {
    threads.emplace_back([&, t] {
      for (std::size_t i = static_cast<std::size_t>(t); i < views.size(); i += 2) {
        views[i] = render(scene, camera, {}, kAllLayers);
      }
    });
  }
  threads.clear();
  for (const View& view : views) {
    EXPECT_EQ(view.shading, alone.shading);
    EXPECT_EQ(view.label, alone.label);
    EXPECT_EQ(view.depth, alone.depth);
    EXPECT_EQ(view.hand_amodal, alone.hand_amodal);
  }
}

TEST(VisiblePoints, AJointIsSeenThroughItsOwnSkinOnly) {
  // A finger of radius 10 mm, one behind it, one behind the object, one outside the picture.
  const Mesh near_finger = capsule({0, 0, 0.5}, 0.01, 0.03);
  const Mesh far_finger = capsule({0, 0, 0.6}, 0.01, 0.03);
  const Mesh side_finger = capsule({0.06, 0, 0.6}, 0.01, 0.03);
  const Mesh object = sphere({0.05, 0, 0.5}, 0.015);
  const Scene scene(joined(joined(near_finger, far_finger), side_finger), {}, &object);
  const std::vector<Eigen::Vector3d> joints = {{0, 0, 0.5},        {0, 0, 0.6},  {0.06, 0, 0.6},
                                               {0.06, 0.025, 0.6}, {0, 0, -0.5}, {0.5, 0, 0.6}};
  const Camera camera = straight_camera(200, 200, 400);
  const std::vector<double> radii(joints.size(), 0.012);
  EXPECT_THAT(visible_points(scene, camera, joints, radii),
              ElementsAre(true, false, false, true, false, false));
  // Each point has a radius of its own: this one is less than the skin over the first.
  const std::vector<double> thin = {0.008, 0.012, 0.012, 0.012, 0.012, 0.012};
  EXPECT_THAT(visible_points(scene, camera, joints, thin),
              ElementsAre(false, false, false, true, false, false));
}

TEST(CropCamera, HoldsAllVerticesTightlyAndLooksFromTheDistance) {
  const Mesh hand = capsule({0.02, 0.05, -0.01}, 0.03, 0.08);
  const Eigen::Matrix3d rotation = rotation_from_vector({0.5, 0.2, -1.0});
  const Eigen::Vector3d center(0.0, 0.03, 0.0);
  for (const double margin : {0.0, 0.1}) {
    const Camera camera = crop_camera(rotation, center, 0.7, hand.vertices, 128, margin);
    EXPECT_LT((camera.camera_from_hand * center - Eigen::Vector3d(0, 0, 0.7)).norm(), 1e-12);
    Eigen::Array2d low(1e9, 1e9), high(-1e9, -1e9);
    for (const Eigen::Vector3f& v : hand.vertices) {
      const Eigen::Array2d pixel =
          camera.intrinsics.project(camera.camera_from_hand * v.cast<double>());
      low = low.min(pixel);
      high = high.max(pixel);
    }
    // The picture reaches from -0.5 to 127.5; the longer side fills it, both are centred.
    const double margin_px = 128 * margin / (1 + 2 * margin);
    EXPECT_NEAR((high - low).maxCoeff(), 128 - 2 * margin_px, 1e-3);
    EXPECT_LT(((high + low) / 2 - 63.5).abs().maxCoeff(), 1e-3);
  }
}

}  // namespace
}  // namespace graspdb
