// SPDX-License-Identifier: MIT
// What other renderers are given is what render() draws.
#include <gmock/gmock.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "graspdb/core/file.h"
#include "graspdb/features/hog.h"
#include "graspdb/hand/rig/rig.h"
#include "graspdb/renderer/image_io.h"
#include "graspdb/sequences/sequence.h"
#include "support/temporary_directory.h"
#include "support/tripod_sequence.h"

namespace graspdb {
namespace {

using nlohmann::json;

template <typename Value>
std::vector<Value> read_array(const std::filesystem::path& file) {
  const std::string bytes = read_text(file);
  EXPECT_EQ(bytes.size() % sizeof(Value), 0U);
  std::vector<Value> values(bytes.size() / sizeof(Value));
  std::memcpy(static_cast<void*>(values.data()), bytes.data(), values.size() * sizeof(Value));
  return values;
}

class SequenceMeshes : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    renderer_ = std::make_unique<SequenceRenderer>(testing::tripod_sequence());
    directory_ = std::make_unique<testing::TemporaryDirectory>();
    write_meshes(mesh_frames(*renderer_), directory_->path());
    header_ = json::parse(read_text(*directory_ / "meshes.json"));
  }
  static void TearDownTestSuite() {
    renderer_.reset();
    directory_.reset();
  }

  static Eigen::Vector3d moved(const json& transform, const Eigen::Vector3f& point) {
    Eigen::Vector3d result;
    for (std::size_t row = 0; row < 3; ++row) {
      result[static_cast<int>(row)] = transform[4 * row + 3];
      for (std::size_t i = 0; i < 3; ++i) {
        result[static_cast<int>(row)] +=
            transform[4 * row + i].get<double>() * static_cast<double>(point[static_cast<int>(i)]);
      }
    }
    return result;
  }

  static std::unique_ptr<SequenceRenderer> renderer_;
  static std::unique_ptr<testing::TemporaryDirectory> directory_;
  static json header_;
};
std::unique_ptr<SequenceRenderer> SequenceMeshes::renderer_;
std::unique_ptr<testing::TemporaryDirectory> SequenceMeshes::directory_;
json SequenceMeshes::header_;

// Grown by a pixel: points on an outline may project beside it.
void expect_inside(const std::vector<Eigen::Vector2d>& points, const Box& box) {
  for (const Eigen::Vector2d& p : points) {
    EXPECT_GT(p.x(), box.x - 1.5);
    EXPECT_LT(p.x(), box.x + box.width + 0.5);
    EXPECT_GT(p.y(), box.y - 1.5);
    EXPECT_LT(p.y(), box.y + box.height + 0.5);
  }
}

// How far the points' own box stays behind, pixels.
double slack(const std::vector<Eigen::Vector2d>& points, const Box& box) {
  Eigen::Array2d low(1e9, 1e9), high(-1e9, -1e9);
  for (const Eigen::Vector2d& p : points) {
    low = low.min(p.array());
    high = high.max(p.array());
  }
  const Eigen::Array2d size = high - low;
  return std::max(std::abs(size.x() - box.width), std::abs(size.y() - box.height));
}

TEST_F(SequenceMeshes, EveryFramesHandFillsTheBoxOfItsPicture) {
  SequenceSpec free = testing::tripod_sequence();
  free.object_visible = false;
  const SequenceRenderer unhidden(free);
  const auto vertices = read_array<Eigen::Vector3f>(*directory_ / "hand_vertices.f32");
  const std::size_t count = header_["hand"]["vertices"];
  ASSERT_EQ(header_["frames"].size(), 4U);
  ASSERT_EQ(vertices.size(), 4 * count);
  for (std::size_t frame = 0; frame < 4; ++frame) {
    std::vector<Eigen::Vector2d> points;
    for (std::size_t i = 0; i < count; ++i)
      points.push_back(free.camera.project(vertices[frame * count + i].cast<double>()));
    const Box box = *tight_box(unhidden.render(static_cast<int>(frame)).hand);
    expect_inside(points, box);
    EXPECT_LT(slack(points, box), 3);
  }
}

TEST_F(SequenceMeshes, TheObjectLiesWhereItIsSeen) {
  const auto vertices = read_array<Eigen::Vector3f>(*directory_ / "object_vertices.f32");
  ASSERT_EQ(vertices.size(), header_["object"]["vertices"]);
  for (int frame = 0; frame < 4; ++frame) {
    // The hand may hide a part of it.
    const Box box = *tight_box(renderer_->render(frame).object);
    std::vector<Eigen::Vector2d> points;
    for (const Eigen::Vector3f& vertex : vertices) {
      const json& pose = header_["frames"][static_cast<std::size_t>(frame)]["camera_from_object"];
      points.push_back(renderer_->spec().camera.project(moved(pose, vertex)));
    }
    Eigen::Vector2d low = points.front(), high = low;
    for (const Eigen::Vector2d& p : points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    EXPECT_LT(low.x(), box.x + 1);
    EXPECT_LT(low.y(), box.y + 1);
    EXPECT_GT(high.x(), box.x + box.width - 2);
    EXPECT_GT(high.y(), box.y + box.height - 2);
  }
}

TEST_F(SequenceMeshes, TrianglesBonesAndBindPoseAreTheHands) {
  const Hand& hand = renderer_->hand();
  EXPECT_EQ(read_array<Triangle>(*directory_ / "hand_triangles.u32"), hand.bind_mesh.triangles);
  EXPECT_EQ(read_array<Eigen::Vector3f>(*directory_ / "hand_bind.f32"), hand.bind_mesh.vertices);
  EXPECT_EQ(read_array<std::uint8_t>(*directory_ / "hand_bones.u8"), strongest_bones(hand));
  EXPECT_EQ(header_["bones"][kForearm]["name"], "forearm");
  EXPECT_EQ(header_["camera"]["cx_px"], 159.5);
}

TEST_F(SequenceMeshes, TheForearmEndsWhereTheSequenceSays) {
  const auto vertices = read_array<Eigen::Vector3f>(*directory_ / "hand_vertices.f32");
  const std::size_t count = header_["hand"]["vertices"];
  for (std::size_t frame = 0; frame < 4; ++frame) {
    const json& pose = header_["frames"][frame]["camera_from_forearm"];
    const Eigen::Vector3d distal(pose[1], pose[5], pose[9]), wrist(pose[3], pose[7], pose[11]);
    double reach = 0;
    for (std::size_t i = 0; i < count; ++i) {
      reach = std::max(reach, (wrist - vertices[frame * count + i].cast<double>()).dot(distal));
    }
    EXPECT_NEAR(reach, 0.05, 1e-4);
  }
}

TEST_F(SequenceMeshes, LabelsAreTheMasksAndTellForearmFromHand) {
  for (int frame = 0; frame < 4; ++frame) {
    const Levels labels =
        read_levels(*directory_ / ("labels/00000" + std::to_string(frame) + ".png"));
    const SequenceFrame seen = renderer_->render(frame);
    std::size_t forearm = 0, hand = 0;
    for (std::size_t i = 0; i < seen.hand.size(); ++i) {
      const int label = labels.gray.data()[i];
      EXPECT_EQ(label == kLabelHand || label == kLabelForearm, seen.hand.data()[i] > 0) << i;
      EXPECT_EQ(label == kLabelObject, seen.object.data()[i] > 0) << i;
      hand += label == kLabelHand;
      forearm += label == kLabelForearm;
    }
    // 35 mm of forearm are seen beyond what counts as hand.
    EXPECT_GT(forearm, hand / 20);
    EXPECT_LT(forearm, hand / 2);
  }
}

TEST_F(SequenceMeshes, AnEmptyHandsFolderHasNoObject) {
  const testing::TemporaryDirectory directory;
  write_meshes(mesh_frames(*renderer_), directory.path());
  SequenceSpec spec = testing::tripod_sequence();
  spec.object_visible = false;
  write_meshes(mesh_frames(SequenceRenderer(spec)), directory.path());
  EXPECT_TRUE(json::parse(read_text(directory / "meshes.json"))["object"].is_null());
  EXPECT_FALSE(std::filesystem::exists(directory / "object_vertices.f32"));
}

}  // namespace
}  // namespace graspdb
