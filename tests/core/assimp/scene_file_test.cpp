// SPDX-License-Identifier: MIT
// What is refused before assimp sees it, and what assimp is not shown. The files are small ones
// that are spoilt in one place.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "graspdb/core/assimp/assimp_scene.h"
#include "graspdb/core/assimp/glb.h"
#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/geometry/mesh_solid.h"
#include "support/temporary_directory.h"
#include "tiny_hand.h"

namespace graspdb {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::TemporaryDirectory;
using testing::TinyHand;

using Spoil = std::function<void(TinyHand&)>;

std::string refusal_of(const std::string& name, std::string_view bytes) {
  const TemporaryDirectory folder;
  write_text(folder / name, bytes);
  Assimp::Importer importer;
  try {
    read_scene(importer, folder / name, 0, "a mesh");
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr(name));
    return error.what();
  }
  return "accepted";
}

std::string refusal_of(const Spoil& spoil) {
  TinyHand hand;
  spoil(hand);
  return refusal_of("hand.glb", glb_file(hand.root.dump(), hand.binary));
}

std::string refusal_of_obj(const std::string& text) {
  return refusal_of("object.obj", text);
}

const std::string kCorners = "v 0 0 0\nv 20 0 0\nv 0 20 0\nv 0 0 20\n";
const std::string kTetrahedron = kCorners + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

std::size_t triangles_of_obj(const std::string& text) {
  const TemporaryDirectory folder;
  write_text(folder / "object.obj", text);
  return load_mesh_solid(folder / "object.obj", 1e-3)->mesh().triangles.size();
}

TEST(SceneFile, GivesTheMeshTheBonesAndTheWriterOfAGlb) {
  const TemporaryDirectory folder;
  const TinyHand hand;
  write_text(folder / "hand.GLB", glb_file(hand.root.dump(), hand.binary));
  Assimp::Importer importer;
  const aiScene& scene = read_scene(importer, folder / "hand.GLB", 0, "a mesh");
  ASSERT_EQ(scene.mNumMeshes, 1);
  EXPECT_EQ(scene.mMeshes[0]->mNumVertices, 4);
  EXPECT_EQ(scene.mMeshes[0]->mNumFaces, 4);
  ASSERT_EQ(scene.mMeshes[0]->mNumBones, 2);
  EXPECT_STREQ(scene.mMeshes[0]->mBones[1]->mName.C_Str(), "tip");
  EXPECT_EQ(scene.mMeshes[0]->mBones[1]->mNumWeights, 4);
}

TEST(SceneFile, AContainerSaysItsTrueLengths) {
  const std::string good = glb_file(R"({"asset": {}})", std::string(8, 'x'));
  EXPECT_EQ(glb_parts(good, "").json, R"({"asset": {}}   )");
  EXPECT_EQ(glb_parts(good, "").binary, "xxxxxxxx");
  for (std::size_t size = 0; size < good.size(); ++size) {
    EXPECT_THROW(glb_parts(good.substr(0, size), "f"), Error) << size;
  }
  for (const std::size_t at : {0, 4, 8, 12, 16, 36, 40}) {  // every word of the three headers
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] + 1);
    bad[at + 3] = static_cast<char>(bad[at + 3] + 1);
    EXPECT_THROW(glb_parts(bad, "f"), Error) << at;
  }
}

TEST(SceneFile, RefusesAGlbWhosePartsAreNotWhereItSays) {
  EXPECT_EQ(refusal_of([](TinyHand&) {}), "accepted");
  const std::vector<std::pair<Spoil, std::string>> spoils = {
      {[](TinyHand& h) { h.accessor("POSITION")["count"] = 5; }, "at most 4 elements"},
      {[](TinyHand& h) { h.accessor("POSITION")["byteOffset"] = 4; }, "at most 3 elements"},
      {[](TinyHand& h) { h.accessor("POSITION")["byteOffset"] = -4; }, "accessors[0].byteOffset"},
      {[](TinyHand& h) { h.accessor("POSITION")["componentType"] = 5125; }, "componentType"},
      {[](TinyHand& h) { h.accessor("POSITION")["bufferView"] = 9; }, "accessors[0].bufferView"},
      {[](TinyHand& h) { h.accessor("POSITION").erase("bufferView"); }, "accessors[0].bufferView"},
      {[](TinyHand& h) {
         h.accessor("POSITION")["sparse"] = {{"count", 1}};
       },
       "sparse.indices"},
      {[](TinyHand& h) { h.view("POSITION")["byteStride"] = 8; }, "a stride of 12"},
      {[](TinyHand& h) { h.view("POSITION")["byteStride"] = 16; }, "at most 3 elements"},
      {[](TinyHand& h) { h.view("POSITION")["byteLength"] = 1000; }, "bufferViews[0].byteLength"},
      {[](TinyHand& h) { h.view("POSITION")["byteOffset"] = -1ULL; }, "bufferViews[0].byteOffset"},
      {[](TinyHand& h) { h.view("POSITION")["buffer"] = 1; }, "bufferViews[0].buffer"},
      {[](TinyHand& h) { h.binary.resize(8); }, "byteLength"},
      {[](TinyHand& h) { h.accessor("JOINTS_0")["count"] = 3; }, "each of 4 vertices"},
      {[](TinyHand& h) { h.primitive()["attributes"].erase("WEIGHTS_0"); }, "WEIGHTS_0"},
      {[](TinyHand& h) { h.primitive()["attributes"].erase("POSITION"); }, "POSITION"},
      {[](TinyHand& h) { h.accessor("indices")["count"] = 2; }, "a triangle"},
      {[](TinyHand& h) { h.binary[h.view("indices")["byteOffset"]] = 4; }, "vertices below 4"},
      {[](TinyHand& h) {
         h.root["skins"][0]["joints"] = {1, 2, 0};
       },
       "each of 3 joints"},
      {[](TinyHand& h) {
         h.root["skins"][0]["joints"] = {1, 2, 1};
       },
       "no joint of the skin yet"},
      {[](TinyHand& h) { h.root["skins"][0]["joints"] = {1}; }, "2 joints or more"},
      {[](TinyHand& h) {
         h.root["skins"][0]["joints"] = {1, 3};
       },
       "skins[0].joints[1]"},
      {[](TinyHand& h) { h.root["nodes"][0]["mesh"] = 1; }, "nodes[0].mesh"},
      {[](TinyHand& h) { h.root["nodes"][0]["skin"] = 1; }, "nodes[0].skin"},
      {[](TinyHand& h) {
         h.root["nodes"][2]["translation"] = {0, 1};
       },
       "nodes[2].translation"},
      {[](TinyHand& h) {
         h.root["nodes"][2]["translation"] = {0, 0, 1e9};
       },
       "numbers up to"},
      {[](TinyHand& h) { h.root["nodes"][2]["name"] = std::string(2000, 'n'); }, "nodes[2].name"},
      {[](TinyHand& h) {
         h.root["nodes"][2]["children"] = {1};
         h.root["scenes"][0]["nodes"] = {0};
       },
       "deep"},
      {[](TinyHand& h) {
         h.root["scenes"][0]["nodes"] = {0, 1, 2};
       },
       "no other one holds"},
      {[](TinyHand& h) { h.root["scene"] = 1; }, "scene"},
      {[](TinyHand& h) { h.root.erase("scenes"); }, "scene"},
      {[](TinyHand& h) { h.root = json::array(); }, "asset"}};
  for (const auto& [spoil, why] : spoils) EXPECT_THAT(refusal_of(spoil), HasSubstr(why));
}

TEST(SceneFile, RefusesNumbersThatAreNone) {
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 2e7F}) {
    const auto spoil = [&](const std::string& name) {
      return [&, name](TinyHand& h) {
        std::memcpy(h.binary.data() + h.view(name)["byteOffset"].get<int>() + 20, &bad, 4);
      };
    };
    EXPECT_THAT(refusal_of(spoil("POSITION")), HasSubstr("accessors[0]"));
    EXPECT_THAT(refusal_of(spoil("WEIGHTS_0")), HasSubstr("accessors[2]"));
  }
}

TEST(SceneFile, RefusesAGlbThatSaysLittleAndMeansMuch) {
  const Spoil chain = [](TinyHand& h) {
    for (std::size_t node = 2; node < 1000; ++node) {
      h.root["nodes"][node]["children"] = {node + 1};
    }
    h.root["nodes"].push_back(json::object());
  };
  EXPECT_THAT(refusal_of(chain), HasSubstr("512 nodes deep"));
  // 100,000 nodes that each show the mesh of 100 primitives.
  const Spoil many = [](TinyHand& h) {
    h.root["nodes"][0].erase("skin");
    for (int i = 1; i < 100; ++i) h.root["meshes"][0]["primitives"].push_back(h.primitive());
    for (std::size_t node = 3; node < 100000; ++node) {
      h.root["nodes"].push_back({{"mesh", 0}});
      h.root["scenes"][0]["nodes"].push_back(node);
    }
  };
  EXPECT_THAT(refusal_of(many), HasSubstr("vertices, indices and bones"));
  // The same by transforms: 2^30 after thirty nodes.
  const Spoil growth = [](TinyHand& h) {
    for (std::size_t node = 2; node < 32; ++node) {
      h.root["nodes"][node] = {{"scale", {2, 2, 2}}, {"children", {node + 1}}};
    }
    h.root["nodes"].push_back(json::object());
  };
  EXPECT_THAT(refusal_of(growth), HasSubstr("numbers up to"));
}

TEST(SceneFile, DoesNotMindWhatItDoesNotUse) {
  const Spoil spoil = [](TinyHand& h) {
    h.root["accessors"].push_back({{"count", 7}});
    h.root["animations"] = {
        {{"samplers", {{{"input", 5}, {"output", 99}}}}, {"channels", {{{"sampler", 3}}}}}};
    h.root["images"] = {{{"bufferView", 99}}};
    h.root["materials"] = {{{"normalTexture", {{"index", 4}}}}};
    h.root["extensionsUsed"] = {"KHR_texture_transform"};
    h.root["nodes"][1]["camera"] = 7;
    h.root["nodes"][1]["extras"] = {{"a", {{"b", 1}}}};
    h.primitive()["targets"] = {{{"POSITION", 5}}};
    h.primitive()["material"] = 0;
    h.primitive()["attributes"]["TEXCOORD_0"] = 5;
    h.root["meshes"][0]["primitives"].push_back({{"mode", 1}});
    h.root["buffers"] = {{{"byteLength", h.binary.size()}},
                         {{"byteLength", 7}, {"uri", "elsewhere.bin"}}};
  };
  EXPECT_EQ(refusal_of(spoil), "accepted");
}

TEST(SceneFile, RefusesJsonThatIsNone) {
  const TinyHand hand;
  for (const char* text : {"", "{", "null", "[1]", "{\"asset\": \xff}"}) {
    EXPECT_NE(refusal_of("hand.glb", glb_file(text, hand.binary)), "accepted") << text;
  }
  EXPECT_THAT(refusal_of("hand.glb", glb_file(std::string(17 << 20, ' '), "")),
              HasSubstr("at most 16 MiB"));
}

TEST(SceneFile, ReadsAnObjInAllItsSpellings) {
  EXPECT_EQ(triangles_of_obj(kTetrahedron), 4);
  EXPECT_EQ(triangles_of_obj("#\r\n" + kCorners + "f -4 -2 -3\nf -4 -3 -1\nf 1 4 3\nf 2 3 4"), 4);
  EXPECT_EQ(triangles_of_obj("mtllib /dev/zero\no a\ng b c\nusemtl d\\\ns off\n" + kCorners +
                             "vt 7\nvn 0 0 1\nf 1/1/1 3/2/1 2/1/1\nf 1/1 2/1 4/9\nf 1//1 \\\n4//1 "
                             "3//1\nf 2 3 4\nl 1 2\np 9\nf 1 2\n"),
            4);
  EXPECT_EQ(triangles_of_obj("v 0 0 0 1\nv 20. +0 .0 1\nv 0 2e1 0 1\nv 0 0 20 1\nf 1 3 2\nf 1 2 4\n"
                             "f 1 4 3\nf 2 3 4\n"),
            4);
}

TEST(SceneFile, RefusesAnObjThatNamesWhatItHasNot) {
  EXPECT_THAT(refusal_of_obj(kCorners + "f 1 2 5\n"), HasSubstr("indices up to 4"));
  EXPECT_THAT(refusal_of_obj(kCorners + "f 1//1 2//1 3//1\n"), HasSubstr("indices up to 0"));
  for (const char* corner :
       {"0", "-5", "x", "1.5", "1e1", "99999999999999999999", "1/1/", "1//x"}) {
    EXPECT_THAT(refusal_of_obj(kCorners + "f 1 2 " + corner + "\n"),
                AllOf(HasSubstr("line 5"), HasSubstr("an index")))
        << corner;
  }
}

TEST(SceneFile, RefusesAnObjWhoseNumbersAreNone) {
  for (const char* number : {"nan", "inf", "1e400", "2e7", "x", "0x1", "1,5", "--1"}) {
    EXPECT_THAT(refusal_of_obj("v 0 0 0\nv 1 2 " + std::string(number) + "\n"),
                AllOf(HasSubstr("line 2"), HasSubstr("a number up to 1e+07")))
        << number;
  }
  EXPECT_THAT(refusal_of_obj("v 1 2\n"), HasSubstr("as many numbers"));
  EXPECT_THAT(refusal_of_obj("v 1 2 3 4 5\n"), HasSubstr("as many numbers"));
  EXPECT_THAT(refusal_of_obj("o " + std::string(600, 'x') + "\n"), HasSubstr("a name"));
}

TEST(SceneFile, RefusesAFileOfAnyFormatThatIsTooLarge) {
  const TemporaryDirectory folder;
  for (const char* name : {"a.glb", "a.obj", "a.stl"}) {
    write_text(folder / name, "x");
    std::filesystem::resize_file(folder / name, 300 << 20);  // takes no room on the disk
    Assimp::Importer importer;
    try {
      read_scene(importer, folder / name, 0, "a mesh");
      FAIL() << name;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), AllOf(HasSubstr(name), HasSubstr("at most 256 MiB")));
    }
  }
}

}  // namespace
}  // namespace graspdb
