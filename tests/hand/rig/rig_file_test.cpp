// SPDX-License-Identifier: MIT
// Files whose nodes are named or turned in ways that assimp gets wrong.
#include <assimp/scene.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <nlohmann/json.hpp>

#include "glb_edit.h"
#include "graspdb/geometry/topology.h"
#include "rig_maps.h"

namespace graspdb {
namespace {

using ::testing::AllOf;
using testing::GlbEdit;
using ::testing::HasSubstr;
using testing::kMale;
using testing::TemporaryDirectory;

// With a second node of the name of one of its bones: `tip` is how the format names little_tip.
std::string exported_with_twins(const std::string& format, const std::string& tip) {
  const TemporaryDirectory folder;
  Assimp::Importer importer;
  Assimp::Exporter exporter;
  exporter.Export(importer.ReadFile(kMale.string(), 0), format, (folder / "hand").string());
  std::string text = read_text(folder / "hand");
  const std::string twin = testing::replaced(tip, "little_tip", "ring_distal");
  return testing::replaced(text, tip, twin);
}

TEST(RigFile, RefusesTwoNodesOfABonesName) {
  const TemporaryDirectory folder;
  const std::string collada = exported_with_twins("collada", "name=\"little_tip\"");
  const std::string fbx = exported_with_twins("fbxa", "\"Model::little_tip\"");
  for (const auto& [name, text] : {std::pair("male.dae", collada), std::pair("male.fbx", fbx)}) {
    write_text(folder / name, text);
    const auto load = [&, path = folder / name] { load_hand(path, rig_map_beside(kMale)); };
    EXPECT_THAT(load, ::testing::ThrowsMessage<Error>(
                          AllOf(HasSubstr("ring_distal"), HasSubstr("one node of this name"))))
        << name;
  }
}

// The right hand as it looks in a mirror, by a node above its joints.
GlbEdit mirrored_male() {
  GlbEdit edit;
  const nlohmann::json below = edit.json["scenes"][0]["nodes"];
  edit.json["scenes"][0]["nodes"] = nlohmann::json::array();
  edit.add_node({{"name", "mirror"}, {"scale", {-1, 1, 1}}, {"children", below}}, "");
  return edit;
}

TEST(RigFile, SkinThatAMirrorTurnsFacesOutwards) {
  const std::string map =
      testing::replaced(testing::map_with("handedness = \"right\"", "handedness = \"left\""),
                        "thumb_nail = [-0.8998708493068355", "thumb_nail = [0.8998708493068355");
  const Hand male = load_hand(kMale), hand = mirrored_male().load(map);
  EXPECT_GT(volume_of(male.bind_mesh), 0);
  EXPECT_NEAR(volume_of(hand.bind_mesh), volume_of(male.bind_mesh), 1e-9);
}

}  // namespace
}  // namespace graspdb
