// SPDX-License-Identifier: MIT
// Objects from a .blend, in metres, closed or refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>

#include "blender.h"
#include "graspdb/core/file.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using ::testing::AllOf;
using testing::BlenderOutcome;
using ::testing::HasSubstr;

// A cylinder of 80 x 80 x 100 mm, by its scale, in a scene in centimetres; its origin is in its
// bottom, and not the world's.
constexpr const char* kScene = R"(
import bpy
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.context.scene.unit_settings.scale_length = 0.01
bpy.ops.mesh.primitive_cylinder_add(vertices=32, radius=2, depth=10, location=(7, 8, 9))
cup = bpy.context.object
cup.scale = (2, 2, 1)
for vertex in cup.data.vertices:
    vertex.co.z += 5
)";

class ExportObject : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!testing::has_blender()) GTEST_SKIP() << testing::kNoBlender;
  }

  BlenderOutcome export_object(const std::string& change, const std::string& file) {
    write_text(folder_ / "scene.py", kScene + change);
    return testing::run_blender(folder_ / "scene.py", "scripts/blender/export_for_graspdb.py",
                                {"object", (folder_ / file).string()});
  }

  const testing::TemporaryDirectory folder_;
};

Eigen::AlignedBox3d box_of_obj(const std::string& text) {
  Eigen::AlignedBox3d box;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("v ", 0) != 0) continue;
    std::istringstream numbers(line.substr(2));
    Eigen::Vector3d v;
    numbers >> v.x() >> v.y() >> v.z();
    box.extend(v);
  }
  return box;
}

TEST_F(ExportObject, ObjIsInMetersWithBlendersAxesAndItsOwnOrigin) {
  const BlenderOutcome outcome = export_object("", "cup.obj");
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  EXPECT_THAT(outcome.output,
              AllOf(HasSubstr("unit: metre"), HasSubstr("80.0 x 80.0 x 100.0 mm"),
                    HasSubstr("[0.0, 0.0, 50.0] mm"), HasSubstr("watertight, 124 triangles")));
  const Eigen::AlignedBox3d box = box_of_obj(read_text(folder_ / "cup.obj"));
  EXPECT_LT((box.min() - Eigen::Vector3d(-.04, -.04, 0)).norm(), 1e-6);
  EXPECT_LT((box.max() - Eigen::Vector3d(.04, .04, .1)).norm(), 1e-6);
}

TEST_F(ExportObject, GlbHasYUpAndStaysClosed) {
  const BlenderOutcome outcome = export_object("", "cup.glb");
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  EXPECT_THAT(outcome.output,
              AllOf(HasSubstr("80.0 x 100.0 x 80.0 mm"), HasSubstr("[0.0, 50.0, 0.0] mm")));
  const std::string glb = read_text(folder_ / "cup.glb");
  std::uint32_t length = 0;
  std::memcpy(&length, glb.data() + 12, 4);
  const auto gltf = nlohmann::json::parse(glb.substr(20, length));
  const auto& mesh = gltf["meshes"][0]["primitives"][0];
  const auto& positions = gltf["accessors"][mesh["attributes"]["POSITION"].get<std::size_t>()];
  EXPECT_EQ(positions["count"], 64);  // none is split
  EXPECT_NEAR(positions["max"][1].get<double>(), .1, 1e-6);
  EXPECT_NEAR(positions["max"][2].get<double>(), .04, 1e-6);
  EXPECT_EQ(gltf["accessors"][mesh["indices"].get<std::size_t>()]["count"], 3 * 124);
}

TEST_F(ExportObject, RefusesAnOpenMesh) {
  const BlenderOutcome outcome = export_object(R"(
import bmesh
cup_mesh = bmesh.new()
cup_mesh.from_mesh(cup.data)
bmesh.ops.delete(cup_mesh, geom=[max(cup_mesh.faces, key=lambda f: len(f.verts))], context="FACES")
cup_mesh.to_mesh(cup.data)
)",
                                               "cup.glb");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("Cylinder is not watertight: 32 edges with one face"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "cup.glb"));
}

TEST_F(ExportObject, RefusesWhatIsInsideOut) {
  const BlenderOutcome outcome = export_object("cup.data.flip_normals()\n", "cup.glb");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("inside out"));
}

TEST_F(ExportObject, TurnsTheFacesOfAMirroredObject) {
  const BlenderOutcome outcome = export_object("cup.scale.x = -2\n", "cup.obj");
  EXPECT_EQ(outcome.code, 0) << outcome.output;
}

TEST_F(ExportObject, AsksWhichOfSeveralMeshes) {
  const BlenderOutcome outcome = export_object("bpy.ops.mesh.primitive_cube_add()\n", "cup.glb");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("choose with --object: Cube, Cylinder"));
}

}  // namespace
}  // namespace graspdb
