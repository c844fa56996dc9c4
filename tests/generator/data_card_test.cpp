// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "graspdb/core/file.h"
#include "graspdb/database/database.h"
#include "graspdb/generator/generator.h"
#include "small_build.h"
#include "support/source_folder.h"
#include "support/temporary_directory.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

using testing::kSource;

class DataCard : public ::testing::Test {
 protected:
  DataCard() { config_.steps = config_.views = 1; }

  json card() {
    const fs::path file = directory_ / "a.graspdb";
    build_database(config_, {.out = file});
    return json::parse(Database::open(file).info().data_card);
  }

  // The male hand with these lines on top of a rig map that states nothing. It keeps its name, so
  // that the committed poses are its own.
  void use_own_hand(const std::string& lines) {
    fs::copy_file(kSource / "assets/hands/male.glb", directory_ / "male.glb");
    const std::string map = read_text(kSource / "assets/hands/male.rig.toml");
    write_text(directory_ / "male.rig.toml", lines + map.substr(map.find("handedness")));
    config_.hands = {directory_ / "male.glb"};
  }

  testing::TemporaryDirectory directory_;
  BuildConfig config_ = testing::small_config();
};

TEST_F(DataCard, SaysWhatItWasMadeOf) {
  const json found = card();
  EXPECT_EQ(found.at("rows"), 4);
  const json hands = json::array(
      {{{"name", "male"}, {"origin", "made by graspdb hand make"}, {"licence", "MIT"}}});
  EXPECT_EQ(found.at("hands"), hands);
  // Shapes of stated size have no owner.
  const json objects =
      json::array({{{"grasp", 3}, {"name", "pipe"}}, {{"grasp", 9}, {"name", "thin tile"}}});
  EXPECT_EQ(found.at("objects"), objects);
  EXPECT_THAT(found.at("licence").get<std::string>(), StartsWith("MIT: "));
}

TEST_F(DataCard, RepeatsWhatARigMapAndAGraspFileState) {
  use_own_hand("origin = \"scanned\"\nlicence = \"CC BY 4.0\"\n");
  config_.only = {19};  // the scissors are a mesh
  const json found = card();
  EXPECT_EQ(found.at("hands").at(0).at("origin"), "scanned");
  EXPECT_EQ(found.at("hands").at(0).at("licence"), "CC BY 4.0");
  EXPECT_EQ(found.at("objects").at(0).at("licence"), "MIT");
  EXPECT_THAT(found.at("licence").get<std::string>(), StartsWith("CC BY 4.0, MIT: "));
}

TEST_F(DataCard, SaysWhenALicenseIsNotStated) {
  use_own_hand("");
  const json found = card();
  EXPECT_EQ(found.at("hands").at(0).at("licence"), "not stated");
  EXPECT_THAT(found.at("licence").get<std::string>(), HasSubstr("ask their authors"));
}

}  // namespace
}  // namespace graspdb
