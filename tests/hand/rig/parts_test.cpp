// SPDX-License-Identifier: MIT
// Meshes without skin that a hand's file holds: nails, rings.
#include <gmock/gmock.h>

#include "glb_edit.h"
#include "graspdb/hand/named_poses.h"
#include "support/compare_hands.h"

namespace graspdb {
namespace {

using ::testing::AllOf;
using testing::GlbEdit;
using ::testing::HasSubstr;
using testing::kMale;

// A tetrahedron of 4 mm edges at the place of its node.
std::size_t add_nail_mesh(GlbEdit& file) {
  const std::vector<float> places = {0, 0, 0, .004F, 0, 0, 0, .004F, 0, 0, 0, .004F};
  const std::vector<std::uint32_t> corners = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  const std::size_t position = file.add_accessor(places, 5126, "VEC3", 3);
  file.json["accessors"].back()["min"] = {0, 0, 0};
  file.json["accessors"].back()["max"] = {.004, .004, .004};
  const std::size_t indices = file.add_accessor(corners, 5125, "SCALAR", 1);
  file.json["meshes"].push_back(
      {{"primitives", {{{"attributes", {{"POSITION", position}}}, {"indices", indices}}}}});
  return file.json["meshes"].size() - 1;
}

GlbEdit with_nail_on(const std::string& holder) {
  GlbEdit file;
  const std::size_t mesh = add_nail_mesh(file);
  file.add_node({{"name", "nail"}, {"mesh", mesh}, {"translation", {0, .01, .01}}}, holder);
  return file;
}

// The corners that the file has beyond the male hand's.
std::vector<Eigen::Vector3f> added(const Mesh& mesh) {
  const auto skin = static_cast<std::ptrdiff_t>(load_hand(kMale).bind_mesh.vertices.size());
  return {mesh.vertices.begin() + skin, mesh.vertices.end()};
}

class PartOn : public ::testing::TestWithParam<std::pair<std::string, int>> {};

TEST_P(PartOn, MovesAsAWholeWithTheBoneThatHoldsIt) {
  const auto& [holder, bone] = GetParam();
  const Hand hand = with_nail_on(holder).load();
  const std::vector<Eigen::Vector3f> at_rest = added(hand.bind_mesh);
  ASSERT_GE(at_rest.size(), 4);
  EXPECT_EQ(hand.bind_mesh.triangles.size(), load_hand(kMale).bind_mesh.triangles.size() + 4);
  const auto frames = hand_from_bones(hand.skeleton, named_pose("fist"));
  const std::vector<Eigen::Vector3f> in_fist = added(pose_skin(hand, frames));
  const auto b = static_cast<std::size_t>(bone);
  const RigidTransform moved = frames[b] * hand.hand_from_bone_at_bind[b].inverse();
  for (std::size_t v = 0; v < at_rest.size(); ++v) {
    EXPECT_LT((moved * at_rest[v].cast<double>() - in_fist[v].cast<double>()).norm(), 1e-6);
    EXPECT_LT((at_rest[v].cast<double>() - hand.hand_from_bone_at_bind[b].translation).norm(), .06);
  }
}

INSTANTIATE_TEST_SUITE_P(Holders, PartOn,
                         ::testing::Values(std::pair("thumb_distal", int{kThumbDistal}),
                                           std::pair("thumb_tip", int{kThumbDistal}),
                                           std::pair("ring_middle", int{finger_bone(2, kMiddle)}),
                                           std::pair("palm", int{kPalm})),
                         [](const auto& part) { return part.param.first; });

TEST(Part, BelowAnotherNodeMovesWithTheNextBoneAbove) {
  GlbEdit file;
  const std::size_t mesh = add_nail_mesh(file);
  file.add_node({{"name", "group"}, {"translation", {0, .01, 0}}}, "index_distal");
  file.add_node({{"name", "nail"}, {"mesh", mesh}, {"translation", {0, 0, .01}}}, "group");
  const Hand below = file.load(), direct = with_nail_on("index_distal").load();
  EXPECT_LT(testing::largest_difference(below.bind_mesh, direct.bind_mesh), 1e-7);
  EXPECT_EQ(testing::weight_of_bones(below.weights.back())[finger_bone(0, kDistal)], 1);
}

TEST(Part, OfAMirroredNodeFacesOutwards) {
  GlbEdit file = with_nail_on("index_distal");
  file.json["nodes"].back()["scale"] = {-1, 1, 1};
  const Mesh mesh = file.load().bind_mesh;
  double volume = 0;
  for (std::size_t t = mesh.triangles.size() - 4; t < mesh.triangles.size(); ++t) {
    const auto corner = [&](std::size_t i) { return mesh.vertices[mesh.triangles[t][i]]; };
    const Eigen::Vector3f a = corner(0), b = corner(1), c = corner(2);
    volume += a.dot(b.cross(c)) / 6;
  }
  EXPECT_NEAR(volume, .004 * .004 * .004 / 6, 2e-9);
}

TEST(Part, ThatHangsFromNoBoneIsRefusedByName) {
  EXPECT_THAT(with_nail_on("").refusal(),
              AllOf(HasSubstr("edited.glb: 'nail'"), HasSubstr("hangs from a bone")));
}

TEST(Part, OnABoneThatIsNotMappedIsRefusedByTheBonesName) {
  const std::string map = testing::map_with("index_metacarpal = [\"index_metacarpal\"]\n", "");
  EXPECT_THAT(with_nail_on("index_metacarpal").refusal(map), HasSubstr("\"index_metacarpal\""));
}

}  // namespace
}  // namespace graspdb
