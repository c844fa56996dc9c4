// SPDX-License-Identifier: MIT
// What a mesh file says of its unit, its axes and the places of its parts.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/geometry/mesh_solid.h"
#include "graspdb/geometry/topology.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using ::testing::HasSubstr;

// A tetrahedron of 20 x 10 x 40 units.
constexpr const char* kPlaces = "0 0 0 20 0 0 0 10 0 0 0 40";
constexpr const char* kFaces = "0 2 1 0 1 3 0 3 2 1 2 3";

std::string collada(const std::string& asset, const std::string& nodes) {
  return fmt::format(R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset>{}</asset><library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="12">{}</float_array><technique_common>
<accessor source="#a" count="4" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/><p>{}</p></triangles>
</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="s">{}</visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)",
                     asset, kPlaces, kFaces, nodes);
}

std::string shown(const std::string& matrix) {
  return "<node><matrix>" + matrix + "</matrix><instance_geometry url=\"#g\"/></node>";
}

const std::string kHere = shown("1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1");
const std::string kMirrored = shown("-1 0 0 -5  0 1 0 0  0 0 1 0  0 0 0 1");

std::string fbx(double centimeters) {
  return fmt::format(R"(; FBX 7.3.0 project file
FBXHeaderExtension: {{
  FBXHeaderVersion: 1003
  FBXVersion: 7300
}}
GlobalSettings: {{
  Version: 1000
  Properties70: {{
    P: "UnitScaleFactor", "double", "Number", "",{}
  }}
}}
Objects: {{
  Geometry: 10, "Geometry::g", "Mesh" {{
    Vertices: *12 {{
      a: 0,0,0,20,0,0,0,10,0,0,0,40
    }}
    PolygonVertexIndex: *12 {{
      a: 0,2,-2,0,1,-4,0,3,-3,1,2,-4
    }}
  }}
  Model: 20, "Model::m", "Mesh" {{
    Version: 232
  }}
}}
Connections: {{
  C: "OO",10,20
  C: "OO",20,0
}}
)",
                     centimeters);
}

class MeshFile : public ::testing::Test {
 protected:
  std::shared_ptr<const Solid> load(const std::string& name, const std::string& text,
                                    std::optional<double> unit = {}) {
    write_text(folder_ / name, text);
    return load_mesh_solid(folder_ / name, unit);
  }
  // Of the box, in millimetres.
  Eigen::Vector3d size(const std::string& name, const std::string& text,
                       std::optional<double> unit = {}) {
    return 2000 * load(name, text, unit)->half_extents();
  }
  std::string refusal(const std::string& name, const std::string& text,
                      std::optional<double> unit = {}) {
    try {
      load(name, text, unit);
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr(name));
      return error.what();
    }
    return "accepted";
  }

 private:
  const testing::TemporaryDirectory folder_;
};

TEST_F(MeshFile, AColladaFilesUnitIsAppliedOnce) {
  const std::string centimeters = collada(R"(<unit name="cm" meter="0.01"/>)", kHere);
  EXPECT_TRUE(size("a.dae", centimeters).isApprox(Eigen::Vector3d(200, 100, 400), 1e-5));
  EXPECT_TRUE(size("a.dae", centimeters, 0.01).isApprox(Eigen::Vector3d(200, 100, 400), 1e-5));
  EXPECT_THAT(refusal("a.dae", centimeters, 0.001), HasSubstr("the file's own, 0.01 m"));
  EXPECT_THAT(refusal("a.dae", centimeters, 1), HasSubstr("'unit'"));
  const std::string halves = collada(R"(<unit meter="1.27e-2" name="half an inch"/>)", kHere);
  EXPECT_TRUE(size("a.dae", halves).isApprox(Eigen::Vector3d(254, 127, 508), 1e-5));
}

TEST_F(MeshFile, WhatStatesNoUnitNeedsOne) {
  const std::string none = collada("", kHere);
  EXPECT_TRUE(size("a.dae", none, 0.001).isApprox(Eigen::Vector3d(20, 10, 40), 1e-5));
  EXPECT_THAT(refusal("a.dae", none), HasSubstr("mm, cm or m"));
  EXPECT_THAT(refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), HasSubstr("mm, cm or m"));
  EXPECT_THAT(refusal("a.dae", collada(R"(<unit meter="0"/>)", kHere)), HasSubstr("more than 0"));
}

TEST_F(MeshFile, AxesAreThoseOfTheFile) {
  for (const char* up : {"X_UP", "Y_UP", "Z_UP"}) {
    const std::string asset = fmt::format(R"(<unit meter="0.001"/><up_axis>{}</up_axis>)", up);
    const Eigen::Vector3d found = size("a.dae", collada(asset, kHere));
    EXPECT_TRUE(found.isApprox(Eigen::Vector3d(20, 10, 40), 1e-5)) << up << found.transpose();
  }
}

TEST_F(MeshFile, AnFbxIsInItsOwnCentimeters) {
  EXPECT_TRUE(size("a.fbx", fbx(1)).isApprox(Eigen::Vector3d(200, 100, 400), 1e-5));
  EXPECT_TRUE(size("a.fbx", fbx(0.1), 0.001).isApprox(Eigen::Vector3d(20, 10, 40), 1e-5));
  EXPECT_THAT(refusal("a.fbx", fbx(1), 0.001), HasSubstr("the file's own, 0.01 m"));
}

TEST_F(MeshFile, AMirroredPartFacesOutwards) {
  const std::string unit = R"(<unit meter="0.001"/>)";
  const auto one = load("a.dae", collada(unit, kMirrored));
  EXPECT_GT(volume_of(welded(one->mesh())), 0);
  // Normals too: at every corner they agree with the triangle.
  for (const Triangle& t : one->mesh().triangles) {
    const Eigen::Vector3f &a = one->mesh().vertices[t[0]], &b = one->mesh().vertices[t[1]],
                          &c = one->mesh().vertices[t[2]];
    EXPECT_GT((b - a).cross(c - a).dot(one->mesh().normals[t[0]]), 0);
  }
  // The same mesh once mirrored and once not.
  const auto two = load("a.dae", collada(unit, kHere + kMirrored));
  EXPECT_NEAR(volume_of(two->mesh()), 2 * volume_of(one->mesh()), 1e-12);
  EXPECT_NEAR(2000 * two->half_extents().x(), 45, 1e-3);
}

TEST_F(MeshFile, AMirroredPartOfAnFbxFacesOutwards) {
  std::string text = fbx(0.1);
  const std::string model = "    Version: 232\n";
  text.replace(text.find(model), model.size(),
               "    Properties70: {\n      P: \"Lcl Scaling\", \"Lcl Scaling\", \"\", "
               "\"A\",1,-1,1\n    }\n");
  EXPECT_EQ(refusal("a.fbx", text), "accepted");
}

TEST_F(MeshFile, RefusesAPartWithoutSize) {
  const std::string flat = shown("1 0 0 0  0 0 0 0  0 0 1 0  0 0 0 1");
  EXPECT_THAT(refusal("a.dae", collada(R"(<unit meter="0.001"/>)", flat)), HasSubstr("a scale"));
}

}  // namespace
}  // namespace graspdb
