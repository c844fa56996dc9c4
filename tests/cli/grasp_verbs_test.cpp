// SPDX-License-Identifier: MIT
// The path of docs/grasps.md: a new grasp file that closes, passes its check and is drawn.
#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "graspdb/core/file.h"
#include "program.h"
#include "support/replaced.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::replaced;
using testing::run_program;
using ::testing::StartsWith;
using testing::TemporaryDirectory;

TEST(GraspNew, TakesTheNextFreeNumberFromAHundred) {
  const TemporaryDirectory folder;
  const auto made = [&](const std::string& name) {
    const Outcome outcome = run_program("grasp new '" + name + "' --out " + folder.path().string());
    return outcome.code == 0 ? outcome.out : outcome.err;
  };
  EXPECT_THAT(made("Jar Lid"), HasSubstr("/100_jar_lid.toml\n"));
  EXPECT_THAT(made("Jar Lid"), HasSubstr("/101_jar_lid.toml\n"));
  std::filesystem::remove(folder / "100_jar_lid.toml");
  EXPECT_THAT(made("Pen"), HasSubstr("/100_pen.toml\n"));
  EXPECT_THAT(made("../Pen"), HasSubstr("NAME"));
  EXPECT_THAT(made(" "), HasSubstr("NAME"));
}

TEST(GraspNew, ItsFileClosesPassesTheCheckAndIsDrawn) {
  const TemporaryDirectory folder;
  run_program("grasp new 'Jar Lid' --out " + folder.path().string());
  const std::string file = (folder / "100_jar_lid.toml").string();
  EXPECT_EQ(run_program("grasp close " + file).code, 0);
  const Outcome checked = run_program("grasp check --json " + file);
  EXPECT_EQ(checked.code, 0) << checked.err;
  const auto grasp = nlohmann::json::parse(checked.out).at("grasps").at(0);
  EXPECT_EQ(grasp.at("id"), 100);
  EXPECT_EQ(grasp.at("name"), "Jar Lid");
  EXPECT_EQ(grasp.at("pass"), true);
  EXPECT_TRUE(grasp.at("failures").empty());
  ASSERT_EQ(grasp.at("steps").size(), 5U);
  const auto& step = grasp.at("steps").at(4);
  for (const char* figure :
       {"penetration_mm", "volume_cm3", "self_penetration_mm", "crossing_mm", "clearance_mm"}) {
    EXPECT_TRUE(step.at(figure).is_number()) << figure;
  }
  EXPECT_THAT(step.at("contacts").get<std::vector<std::string>>(), Contains("thumb_distal"));

  const Outcome told = run_program("grasp check " + file);
  EXPECT_THAT(told.out, StartsWith("ok   100 Jar Lid: ball\n"
                                   "         the object's x, y and z: 50.0 x 50.0 x 50.0 mm\n"));
  EXPECT_EQ(grasp.at("object_size_mm").size(), 3U);
  const std::string sheet = (folder / "steps.png").string();
  EXPECT_EQ(run_program("grasp sheet --steps --out " + sheet + " " + file).code, 0);
  EXPECT_THAT(read_text(sheet), StartsWith("\x89PNG"));
}

TEST(GraspCheck, NamesWhatIsWrongWithAFile) {
  const TemporaryDirectory folder;
  run_program("grasp new Odd --out " + folder.path().string());
  const std::string good = read_text(folder / "100_odd.toml");
  const auto told_of = [&](const std::string& text) {
    write_text(folder / "odd.toml", text);
    const Outcome outcome = run_program("grasp check " + (folder / "odd.toml").string());
    EXPECT_EQ(outcome.code, 1);
    return outcome.err + outcome.out;
  };
  const auto told = [&](const std::string& part, const std::string& other) {
    return told_of(replaced(good, part, other));
  };
  EXPECT_THAT(told("diameter_mm = 50", "diameter_mm = 50\ncolour = 1"), HasSubstr("object.colour"));
  EXPECT_THAT(told("diameter_mm = 50", "diameter = 50"), HasSubstr("object.diameter_mm"));
  EXPECT_THAT(told("mcp = 40", "mcp = 140"), HasSubstr("start.index_deg.mcp"));
  EXPECT_THAT(told("\"sphere\"\ndiameter_mm = 50", "\"mesh\"\nmesh = \"no.obj\"\nunit = \"mm\""),
              HasSubstr("no.obj"));
  // The outer sides of index and little finger do not meet on a pea.
  const std::string pea = replaced(replaced(good, "diameter_mm = 50", "diameter_mm = 8"),
                                   "index = [\"pulp\"]", "index = [\"proximal_radial\"]");
  EXPECT_THAT(told_of(replaced(pea, "free = [\"palm\", \"ring\", \"little\"]",
                               "little = [\"proximal_ulnar\"]")),
              HasSubstr("must touch but is"));
}

}  // namespace
}  // namespace graspdb
