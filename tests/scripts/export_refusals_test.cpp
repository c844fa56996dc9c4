// SPDX-License-Identifier: MIT
// Scenes that hold no hand to export, and what is said of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "blender.h"
#include "graspdb/core/file.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using ::testing::HasSubstr;

// A cube on the one bone of an armature.
constexpr const char* kCubeScene = R"(
import bpy
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.object.armature_add()
armature = bpy.context.object
armature.data.bones[0].name = "hand_l"
bpy.ops.mesh.primitive_cube_add()
cube = bpy.context.object
cube.modifiers.new("skin", "ARMATURE").object = armature
group = cube.vertex_groups.new(name="hand_l")
group.add(range(8), 1, "REPLACE")
)";
constexpr const char* kSecondHand = R"(
bpy.context.view_layer.objects.active = armature
bpy.ops.object.mode_set(mode="EDIT")
armature.data.edit_bones.new("hand_r").tail = (0, 0, 1)
bpy.ops.object.mode_set(mode="OBJECT")
cube.vertex_groups.new(name="hand_r").add([0], 1, "REPLACE")
)";

struct Refusal {
  const char* name;
  const char* change;  // of the scene
  const char* said;
};

class ExportHandRefuses : public ::testing::TestWithParam<Refusal> {};

TEST_P(ExportHandRefuses, AndSaysWhy) {
  if (!testing::has_blender()) GTEST_SKIP() << testing::kNoBlender;
  const testing::TemporaryDirectory folder;
  write_text(folder / "scene.py", std::string(kCubeScene) + GetParam().change);
  const testing::BlenderOutcome outcome =
      testing::run_blender(folder / "scene.py", "scripts/blender/export_for_graspdb.py",
                           {"hand", (folder / "a.glb").string()});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.output, HasSubstr(GetParam().said));
  EXPECT_FALSE(std::filesystem::exists(folder / "a.glb"));
}

constexpr auto kRefusalName = [](const auto& info) { return info.param.name; };
INSTANTIATE_TEST_SUITE_P(
    Scenes, ExportHandRefuses,
    ::testing::Values(
        Refusal{"NoArmature", "bpy.data.objects.remove(armature)\n", "no armature"},
        Refusal{"TwoArmatures", "bpy.ops.object.armature_add()\n",
                "choose with --armature: Armature, Armature.001"},
        Refusal{"NoSkin", "cube.modifiers.clear()\n", "no mesh is skinned to armature Armature"},
        Refusal{"LooseSkin", "group.remove([3, 5])\n", "2 vertices move with no bone, e.g. 3"},
        Refusal{"TwoHands", kSecondHand, "choose with --side"},
        Refusal{"Mirrored", "cube.scale.x = -1\n", "Cube is mirrored"}),
    kRefusalName);

}  // namespace
}  // namespace graspdb
