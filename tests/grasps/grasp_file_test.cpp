// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <fstream>

#include "graspdb/core/error.h"
#include "graspdb/grasps/grasp.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string kGood = R"(number = 101
name = "Jar Hold"

[taxonomy]
type = "power"
opposition = "palm"
virtual_fingers = ["palm", "index+middle"]
thumb = "abducted"

[touch]
palm = ["hollow"]
index = ["pulp", "middle_radial"]
middle = ["pulp"]
free = ["little"]

[object]
name = "jar"
shape = "cylinder"
diameter_mm = 60
length_mm = 90
position_mm = [5, 80, -45]
z_axis = [2, 0, 0]
x_axis = [0.5, 3, 0]
approach_mm = [0, 0, -20]

[start]
wrist_deg = { flexion = -20 }
thumb_deg = { cmc_abduction = 45, ip = 10 }
index_deg = { mcp = 40, abduction = 5, pip = 50, dip = 25 }
)";

class GraspFile : public ::testing::Test {
 protected:
  Grasp load(const std::string& text) {
    const auto path = folder_ / "jar.toml";
    std::ofstream(path) << text;
    return load_grasp(path);
  }
  // The message of the Error for the good file with `part` replaced.
  std::string refusal(const std::string& part, const std::string& other) {
    std::string text = kGood;
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    text.replace(at, part.size(), other);
    try {
      load(text);
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("jar.toml"));
      return error.what();
    }
    return "accepted";
  }

  testing::TemporaryDirectory folder_;
};

TEST_F(GraspFile, SaysWhatAGraspIs) {
  const Grasp grasp = load(kGood);
  EXPECT_EQ(grasp.id, 101);
  EXPECT_EQ(grasp.name, "Jar Hold");
  EXPECT_EQ(grasp.type, "power");
  EXPECT_EQ(grasp.opposition, Opposition::kPalm);
  EXPECT_TRUE(grasp.thumb_abducted);
  EXPECT_THAT(grasp.virtual_fingers, ElementsAre(ElementsAre(0), ElementsAre(2, 3)));
  EXPECT_THAT(grasp.required_digits, ElementsAre(0, 2, 3));
  EXPECT_THAT(grasp.free_digits, ElementsAre(5));
  EXPECT_EQ(grasp.contacts.size(), 4U);
  EXPECT_EQ(grasp.contacts[2].side, SkinSide::kRadial);
}

TEST_F(GraspFile, AnglesAndSizesComeInSiUnits) {
  const Grasp grasp = load(kGood);
  EXPECT_NEAR(grasp.start.angles[kWristFlexion], radians(-20), 1e-12);
  EXPECT_NEAR(grasp.start.angles[finger_angle(0, kPipFlexion)], radians(50), 1e-12);
  EXPECT_EQ(grasp.start.angles[finger_angle(3, kPipFlexion)], 0);
  EXPECT_EQ(grasp.object->half_extents(), Eigen::Vector3d(0.03, 0.03, 0.045));
  EXPECT_TRUE(grasp.approach.isApprox(Eigen::Vector3d(0, 0, -0.02)));
}

TEST_F(GraspFile, ObjectLiesAlongItsAxes) {
  const RigidTransform placed = load(kGood).start.hand_from_object;
  EXPECT_TRUE(placed.translation.isApprox(Eigen::Vector3d(0.005, 0.08, -0.045)));
  EXPECT_TRUE(placed.rotation.col(2).isApprox(Eigen::Vector3d::UnitX()));
  EXPECT_TRUE(placed.rotation.col(0).isApprox(Eigen::Vector3d::UnitY()));
  EXPECT_NEAR(placed.rotation.determinant(), 1, 1e-12);
}

const std::string kWaypoint =
    "\n[[waypoint]]\nat_percent = 40\nthumb_deg = { ip = 5 }\napproach_mm = [0, 0, -30]\n";

TEST_F(GraspFile, WaypointsStateSomeAnglesAndPerhapsAnApproach) {
  const Grasp grasp = load(kGood + kWaypoint + "[[waypoint]]\nat_percent = 60\n");
  ASSERT_EQ(grasp.waypoints.size(), 2U);
  const Waypoint& point = grasp.waypoints.front();
  EXPECT_NEAR(point.progress, 0.4, 1e-12);
  EXPECT_NEAR(point.angles[kThumbIpFlexion], radians(5), 1e-12);
  EXPECT_TRUE(std::isnan(point.angles[kThumbMcpFlexion]));
  EXPECT_TRUE(point.approach->isApprox(Eigen::Vector3d(0, 0, -0.03)));
  EXPECT_FALSE(grasp.waypoints.back().approach);
}

TEST_F(GraspFile, RefusesWaypointsOutOfOrderOrRange) {
  const auto refused = [&](const std::string& waypoints) {
    return refusal("index_deg = { mcp = 40, abduction = 5, pip = 50, dip = 25 }\n", waypoints);
  };
  EXPECT_THAT(refused(kWaypoint + kWaypoint), HasSubstr("more than 40"));
  EXPECT_THAT(refused("[[waypoint]]\nat_percent = 100\n"), HasSubstr("at_percent"));
  EXPECT_THAT(refused("[[waypoint]]\nat_percent = 50\nthumb_deg = { ip = 99 }\n"),
              HasSubstr("thumb_deg.ip"));
  EXPECT_THAT(refused("[[waypoint]]\nat_percent = 50\nstep = 2\n"), HasSubstr("step"));
}

TEST_F(GraspFile, RefusesWhatItDoesNotKnow) {
  EXPECT_THAT(refusal("name = \"Jar Hold\"", "name = \"x\"\ncolour = 1"), HasSubstr("colour"));
  EXPECT_THAT(refusal("ip = 10", "pip = 10"), HasSubstr("start.thumb_deg.pip"));
  EXPECT_THAT(refusal("index_deg", "index"), HasSubstr("start.index"));
  EXPECT_THAT(refusal("\"cylinder\"", "\"torus\""), HasSubstr("object.shape"));
  EXPECT_THAT(refusal("\"middle_radial\"", "\"knuckle\""), HasSubstr("knuckle"));
  EXPECT_THAT(refusal("\"index+middle\"", "\"index+toe\""), HasSubstr("toe"));
  EXPECT_THAT(refusal("\"power\"", "\"strong\""), HasSubstr("strong"));
}

const std::string kCylinder = "shape = \"cylinder\"\ndiameter_mm = 60\nlength_mm = 90";
const std::string kMug = GRASPDB_SOURCE_DIR "/assets/objects/mug.obj";

std::string with_object(const std::string& object) {
  std::string text = kGood;
  return text.replace(text.find(kCylinder), kCylinder.size(), object);
}

TEST_F(GraspFile, ARingIsKnownByItsHoleAndItsWire) {
  const Grasp grasp =
      load(with_object("shape = \"ring\"\ninner_diameter_mm = 26\nthickness_mm = 6"));
  EXPECT_TRUE(grasp.object->half_extents().isApprox(Eigen::Vector3d(0.019, 0.019, 0.003)));
  EXPECT_TRUE(grasp.object_file.empty());
}

TEST_F(GraspFile, AMeshIsFoundFromTheFileAndScaledByItsUnit) {
  std::filesystem::copy_file(kMug, folder_ / "mug.obj");
  const Grasp grasp = load(with_object("shape = \"mesh\"\nmesh = \"mug.obj\"\nunit = \"mm\""));
  EXPECT_NEAR(grasp.object->half_extents().z(), 0.0475, 1e-4);
  EXPECT_EQ(grasp.object_file, folder_ / "mug.obj");
}

TEST_F(GraspFile, AnObjectScalesWithTheHandOnlyWhenTheFileSaysSo) {
  EXPECT_FALSE(load(kGood).object_scales);
  EXPECT_TRUE(load(with_object(kCylinder + "\nscales_with_hand = true")).object_scales);
}

TEST_F(GraspFile, RefusesAMeshWithoutAFileOrAUnit) {
  const std::string mug = "shape = \"mesh\"\nmesh = \"" + kMug + "\"";
  EXPECT_THAT(refusal(kCylinder, mug), HasSubstr("object.unit"));
  EXPECT_THAT(refusal(kCylinder, mug + "\nunit = \"inch\""), HasSubstr("mm, cm, m"));
  EXPECT_THAT(refusal(kCylinder, "shape = \"mesh\"\nmesh = \"cup.obj\"\nunit = \"mm\""),
              AllOf(HasSubstr("object.mesh"), HasSubstr("none at"), HasSubstr("cup.obj")));
  const std::string endless(300, 'x');  // no file can have such a name
  EXPECT_THAT(refusal(kCylinder, "shape = \"mesh\"\nmesh = \"" + endless + "\"\nunit = \"mm\""),
              HasSubstr("object.mesh"));
  EXPECT_THAT(refusal(kCylinder, mug + "\nunit = \"mm\"\ndiameter_mm = 80"),
              HasSubstr("object.diameter_mm"));
}

TEST_F(GraspFile, RefusesAMeshThatIsNotWatertight) {
  std::ofstream(folder_ / "open.obj") << "v 0 0 0\nv 20 0 0\nv 0 20 0\nv 0 0 20\n"
                                         "f 1 3 2\nf 1 2 4\nf 1 4 3\n";
  try {
    load(with_object("shape = \"mesh\"\nmesh = \"open.obj\"\nunit = \"mm\""));
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(),
                AllOf(HasSubstr("open.obj"), HasSubstr("watertight"), HasSubstr("3 open edges")));
  }
}

TEST_F(GraspFile, RefusesASizeWithoutItsUnit) {
  EXPECT_THAT(refusal("diameter_mm = 60", "diameter = 60"), HasSubstr("object.diameter_mm"));
  EXPECT_THAT(refusal("position_mm", "position"), HasSubstr("object.position_mm"));
}

TEST_F(GraspFile, RefusesValuesOutOfRange) {
  EXPECT_THAT(refusal("mcp = 40", "mcp = 140"), HasSubstr("start.index_deg.mcp"));
  EXPECT_THAT(refusal("flexion = -20", "flexion = -90"), HasSubstr("-70"));
  EXPECT_THAT(refusal("diameter_mm = 60", "diameter_mm = -60"), HasSubstr("diameter_mm"));
  EXPECT_THAT(refusal("number = 101", "number = 0"), HasSubstr("number"));
}

TEST_F(GraspFile, RefusesAbductionThatTheFlexionDoesNotAllow) {
  EXPECT_THAT(refusal("mcp = 40, abduction = 5", "mcp = 80, abduction = 5"),
              HasSubstr("index_mcp_abduction"));
}

TEST_F(GraspFile, RefusesAVirtualFingerThatTouchesNothing) {
  EXPECT_THAT(refusal("\"index+middle\"", "\"index+ring\""), HasSubstr("ring"));
}

TEST_F(GraspFile, RefusesAFreeDigitThatTouches) {
  EXPECT_THAT(refusal("\"little\"", "\"index\""), HasSubstr("touch.free"));
}

TEST_F(GraspFile, RefusesAxesThatAreNone) {
  EXPECT_THAT(refusal("z_axis = [2, 0, 0]", "z_axis = [0, 0, 0]"), HasSubstr("z_axis"));
  EXPECT_THAT(refusal("x_axis = [0.5, 3, 0]", "x_axis = [1, 0, 0]"), HasSubstr("x_axis"));
}

TEST_F(GraspFile, RefusesTwoGraspsOfOneNumber) {
  std::ofstream(folder_ / "a.toml") << kGood;
  std::ofstream(folder_ / "b.toml") << kGood;
  EXPECT_THROW(load_grasps(folder_.path()), Error);
}

TEST_F(GraspFile, RefusesAFolderThatIsNone) {
  EXPECT_THROW(load_grasps(folder_ / "nowhere"), Error);
}

TEST(CommittedGrasps, LoadInTheOrderOfTheirNumbers) {
  const std::vector<Grasp> grasps = load_grasps(GRASPDB_SOURCE_DIR "/grasps");
  std::vector<int> ids;
  for (const Grasp& grasp : grasps) ids.push_back(grasp.id);
  EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));
  for (const int id : {1, 2, 3, 6, 9, 11, 12, 13, 14, 16, 18, 22, 24, 27, 31, 33}) {
    EXPECT_THAT(ids, ::testing::Contains(id));
  }
}

TEST(CommittedGrasps, RestPoseIsWithinTheRanges) {
  const JointAngles rest = load_rest_pose(GRASPDB_SOURCE_DIR "/grasps");
  EXPECT_EQ(range_excess(rest), 0);
  EXPECT_GT(rest.norm(), 0.5);
}

}  // namespace
}  // namespace graspdb
