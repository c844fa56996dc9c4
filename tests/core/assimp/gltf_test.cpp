// SPDX-License-Identifier: MIT
// Legal glTF files that assimp reads wrongly or not at all: they give what plain ones give, or are
// refused by the name of what is not read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "graspdb/core/assimp/assimp_scene.h"
#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "support/temporary_directory.h"
#include "tiny_hand.h"

namespace graspdb {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using namespace testing;

class Gltf : public ::testing::Test {
 protected:
  const aiMesh& read(const std::string& name, std::string_view bytes) {
    write_text(folder_ / name, bytes);
    return *read_scene(importer_, folder_ / name, 0, "a mesh").mMeshes[0];
  }
  const aiMesh& read(const TinyHand& hand) { return read("hand.glb", hand.glb()); }

  std::string refusal(const std::string& name, std::string_view bytes) {
    try {
      read(name, bytes);
    } catch (const Error& error) {
      return error.what();
    }
    return "accepted";
  }
  std::string refusal(const TinyHand& hand) { return refusal("hand.glb", hand.glb()); }

  const TemporaryDirectory folder_;
  Assimp::Importer importer_;
};

void expect_place(const aiMesh& mesh, unsigned vertex, const Eigen::Vector3f& place) {
  ASSERT_LT(vertex, mesh.mNumVertices);
  EXPECT_LT((to_eigen(mesh.mVertices[vertex]) - place).norm(), 1e-5)
      << to_eigen(mesh.mVertices[vertex]).transpose();
}

TEST_F(Gltf, ASkinWithoutInverseBindMatricesHasIdentities) {
  TinyHand hand;
  hand.root["skins"][0].erase("inverseBindMatrices");
  const aiMesh& mesh = read(hand);
  ASSERT_EQ(mesh.mNumBones, 2);
  for (unsigned b = 0; b < 2; ++b) EXPECT_TRUE(mesh.mBones[b]->mOffsetMatrix.IsIdentity());
}

TEST_F(Gltf, WeightsOfWholeNumbersAreShares) {
  TinyHand hand;
  json& attributes = hand.primitive()["attributes"];
  attributes["JOINTS_0"] =
      hand.add<std::uint16_t>({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, kShorts, 4, "VEC4");
  attributes["WEIGHTS_0"] = hand.add<std::uint8_t>(
      {51, 204, 0, 0, 255, 0, 0, 0, 0, 255, 0, 0, 102, 153, 0, 0}, kBytes, 4, "VEC4");
  hand.accessor("WEIGHTS_0")["normalized"] = true;
  const aiMesh& bytes = read(hand);
  EXPECT_FLOAT_EQ(bytes.mBones[0]->mWeights[0].mWeight, 0.2F);
  EXPECT_FLOAT_EQ(bytes.mBones[1]->mWeights[0].mWeight, 0.8F);
  attributes["WEIGHTS_0"] = hand.add<std::uint16_t>(
      {13107, 52428, 0, 0, 65535, 0, 0, 0, 0, 65535, 0, 0, 65535, 0, 0, 0}, kShorts, 4, "VEC4");
  const aiMesh& shorts = read(hand);
  EXPECT_FLOAT_EQ(shorts.mBones[0]->mWeights[0].mWeight, 0.2F);
  EXPECT_FLOAT_EQ(shorts.mBones[1]->mWeights[0].mWeight, 0.8F);
}

TEST_F(Gltf, SetsOfJointsMayBeOfDifferentNumbers) {
  TinyHand hand;
  json& attributes = hand.primitive()["attributes"];
  attributes["JOINTS_1"] = hand.add(std::vector<std::uint16_t>(16, 0), kShorts, 4, "VEC4");
  attributes["WEIGHTS_1"] = hand.add(std::vector<float>(16, 0.5F), kFloats, 4, "VEC4");
  EXPECT_EQ(read(hand).mBones[0]->mNumWeights, 16);
  EXPECT_EQ(read(hand).mBones[1]->mNumWeights, 4);
}

TEST_F(Gltf, QuantizedPlacesAreThoseTheyStandFor) {
  TinyHand hand;
  hand.root["extensionsRequired"] = {"KHR_mesh_quantization"};
  const auto place = [&](std::size_t accessor, bool is_normalized) {
    hand.primitive()["attributes"]["POSITION"] = accessor;
    hand.accessor("POSITION")["normalized"] = is_normalized;
    hand.view("POSITION")["byteStride"] = hand.view("POSITION")["byteLength"].get<int>() / 4;
  };
  // Three numbers and a gap, as glTF aligns every vertex to four bytes.
  place(hand.add<std::int16_t>({0, 0, 0, 9, 32767, 0, 0, 9, 0, -32767, 0, 9, 0, 0, -32768, 9},
                               kSignedShorts, 4, "VEC3"),
        true);
  expect_place(read(hand), 1, {1, 0, 0});
  expect_place(read(hand), 2, {0, -1, 0});
  expect_place(read(hand), 3, {0, 0, -1});
  place(hand.add<std::uint16_t>({0, 0, 0, 9, 300, 0, 0, 9, 0, 20, 0, 9, 0, 0, 65535, 9}, kShorts, 4,
                                "VEC3"),
        false);
  expect_place(read(hand), 1, {300, 0, 0});
  expect_place(read(hand), 3, {0, 0, 65535});
  place(hand.add<std::int8_t>({0, 0, 0, 9, 127, 0, 0, 9, 0, -128, 0, 9, 0, 0, 64, 9}, kSignedBytes,
                              4, "VEC3"),
        true);
  expect_place(read(hand), 2, {0, -1, 0});
  expect_place(read(hand), 3, {0, 0, 64 / 127.F});
  place(hand.add<std::uint8_t>({0, 0, 0, 9, 255, 0, 0, 9, 0, 51, 0, 9, 0, 0, 1, 9}, kBytes, 4,
                               "VEC3"),
        true);
  expect_place(read(hand), 1, {1, 0, 0});
  expect_place(read(hand), 2, {0, 0.2F, 0});
}

// One element that is changed.
json sparse_change(std::size_t where, std::size_t what) {
  return {{"count", 1},
          {"indices", {{"bufferView", where}, {"componentType", kBytes}}},
          {"values", {{"bufferView", what}}}};
}

TEST_F(Gltf, SparseAccessorsAreChanged) {
  TinyHand hand;
  const std::size_t where = hand.add<std::uint8_t>({3}, kBytes, 1, "SCALAR");
  const std::size_t what = hand.add<float>({1, 2, 30}, kFloats, 1, "VEC3");
  hand.accessor("POSITION")["sparse"] = sparse_change(where, what);
  expect_place(read(hand), 1, {20, 0, 0});
  expect_place(read(hand), 3, {1, 2, 30});
  // Without bytes of its own an accessor is all zeros before that.
  hand.accessor("POSITION").erase("bufferView");
  expect_place(read(hand), 1, {0, 0, 0});
  expect_place(read(hand), 3, {1, 2, 30});
}

TEST_F(Gltf, RefusesSparseChangesThatAreNotThere) {
  TinyHand hand;
  const std::size_t where = hand.add<std::uint8_t>({4}, kBytes, 1, "SCALAR");
  const std::size_t what = hand.add<float>({1, 2, 30}, kFloats, 1, "VEC3");
  const json good = sparse_change(where, what);
  const auto refusal_of = [&](const std::function<void(json&)>& spoil) {
    json& sparse = hand.accessor("POSITION")["sparse"] = good;
    spoil(sparse);
    return refusal(hand);
  };
  EXPECT_THAT(refusal_of([](json&) {}), HasSubstr("elements below 4"));
  EXPECT_THAT(refusal_of([](json& s) { s["count"] = 2; }), HasSubstr("at most 1 elements"));
  EXPECT_THAT(refusal_of([](json& s) { s["count"] = 5; }), HasSubstr("sparse.count"));
  EXPECT_THAT(refusal_of([](json& s) { s["values"]["byteOffset"] = 4; }), HasSubstr("at most 0"));
  EXPECT_THAT(refusal_of([](json& s) { s["indices"]["bufferView"] = 99; }), HasSubstr("below"));
  hand.accessor("POSITION").erase("bufferView");
  for (const std::size_t many : {std::size_t{2'000'000}, std::size_t{1} << 60}) {
    hand.accessor("POSITION")["count"] = many;
    EXPECT_THAT(refusal_of([](json&) {}), HasSubstr("accessors[0].count"));
  }
}

TEST_F(Gltf, NamesTheRequiredExtensionThatIsNotRead) {
  TinyHand hand;
  for (const char* name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression",
                           "EXT_mesh_gpu_instancing", "KHR_node_visibility", "ACME_anything"}) {
    hand.root["extensionsRequired"] = {"KHR_materials_unlit", name};
    EXPECT_THAT(refusal(hand), HasSubstr(name));
    EXPECT_THAT(refusal(hand), HasSubstr("extensionsRequired[1]"));
  }
  hand.root["extensionsRequired"] = {"KHR_materials_unlit", "KHR_texture_basisu",
                                     "KHR_lights_punctual", "EXT_texture_webp"};
  EXPECT_EQ(refusal(hand), "accepted");
}

TEST_F(Gltf, RefusesAShapeKeyThatIsNotAtZero) {
  TinyHand hand;
  hand.root["meshes"][0]["weights"] = {0, 0.0};
  EXPECT_EQ(refusal(hand), "accepted");
  hand.root["nodes"][0]["weights"] = {0, 0.5};
  EXPECT_THAT(refusal(hand), HasSubstr("nodes[0].weights[1]"));
  hand.root["nodes"][0].erase("weights");
  hand.root["meshes"][0]["weights"] = {1};
  EXPECT_THAT(refusal(hand), HasSubstr("meshes[0].weights[0]"));
}

TEST_F(Gltf, AJointHasANameOfItsOwn) {
  TinyHand twins;
  twins.root["nodes"][2]["name"] = "wrist";
  EXPECT_THAT(refusal(twins), HasSubstr("2 of the name wrist"));
  TinyHand hand;
  hand.root["nodes"][0]["name"] = "tip";  // the node of the mesh
  EXPECT_THAT(refusal(hand), HasSubstr("2 of the name tip"));
  TinyHand others;  // what is no joint may have any name
  others.root["skins"][0]["joints"] = {1, 2};
  others.root["nodes"].push_back({{"name", "lamp"}});
  others.root["nodes"].push_back({{"name", "lamp"}});
  EXPECT_EQ(refusal(others), "accepted");
}

TEST_F(Gltf, AJointWithoutANameIsOneThingAsABoneAndAsANode) {
  TinyHand hand;
  hand.root["nodes"][2].erase("name");
  const std::string name = read(hand).mBones[1]->mName.C_Str();
  EXPECT_NE(importer_.GetScene()->mRootNode->FindNode(name.c_str()), nullptr) << name;
}

TEST_F(Gltf, AMeshWithASkinIsShownOnce) {
  TinyHand hand;
  hand.root["nodes"].push_back({{"mesh", 0}, {"skin", 0}});
  hand.root["scenes"][0]["nodes"] = {0, 1, 3};
  EXPECT_THAT(refusal(hand), HasSubstr("nodes[3].mesh"));
}

// 64 digits for every six bits.
std::string in_base64(const std::string& bytes) {
  constexpr const char* kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t bit = 0; bit < 8 * bytes.size(); bit += 6) {
    unsigned digit = 0;
    for (std::size_t i = bit; i < bit + 6; ++i) {
      const unsigned byte = i / 8 < bytes.size() ? static_cast<unsigned char>(bytes[i / 8]) : 0;
      digit = 2 * digit + (byte >> (7 - i % 8) & 1U);
    }
    text += kDigits[digit];
  }
  return text + std::string((4 - text.size() % 4) % 4, '=');
}

TEST_F(Gltf, BuffersAreInTheFileOrBesideIt) {
  TinyHand hand;
  const auto with_uri = [&](const std::string& uri) {
    hand.root["buffers"] = {{{"byteLength", hand.binary.size()}, {"uri", uri}}};
    return hand.root.dump();
  };
  const std::string data = "data:application/octet-stream;base64," + in_base64(hand.binary);
  expect_place(read("hand.gltf", with_uri(data)), 3, {0, 0, 20});
  write_text(folder_ / "the hand.bin", hand.binary);
  expect_place(read("hand.gltf", with_uri("the%20hand.bin")), 3, {0, 0, 20});
  expect_place(read("hand.glb", glb_file(with_uri("the hand.bin"), "")), 3, {0, 0, 20});
  EXPECT_EQ(read("hand.gltf", with_uri(data)).mNumBones, 2);
}

TEST_F(Gltf, NoBufferIsOutsideTheFolder) {
  TinyHand hand;
  write_text(folder_ / "hand.bin", hand.binary);
  const auto refusal_of = [&](const std::string& uri) {
    hand.root["buffers"] = {{{"byteLength", hand.binary.size()}, {"uri", uri}}};
    return refusal("inside/hand.gltf", hand.root.dump());
  };
  for (const std::string& uri : std::vector<std::string>{
           "../hand.bin", "%2e%2e/hand.bin", "a/../../hand.bin", "/dev/zero", "file:///hand.bin",
           "", "..\\hand.bin", "hand%00.bin", (folder_ / "hand.bin").string()}) {
    EXPECT_THAT(refusal_of(uri), HasSubstr("a file in this folder or below it")) << uri;
  }
  EXPECT_THAT(refusal_of("absent.bin"), HasSubstr("absent.bin"));
  EXPECT_THAT(refusal_of("%4x.bin"), HasSubstr("hexadecimal"));
  EXPECT_THAT(refusal_of("data:;base64,AA*A"), HasSubstr("base 64"));
  EXPECT_THAT(refusal_of("data:text/plain,AAAA"), HasSubstr("base 64"));
  EXPECT_THAT(refusal_of("data:;base64,AAAA"), HasSubstr("byte"));
}

TEST_F(Gltf, AGltfIsCheckedAsAGlbIs) {
  TinyHand hand;
  hand.root["buffers"] = {{{"uri", "data:;base64," + in_base64(hand.binary)}}};
  hand.accessor("indices")["count"] = 99;
  EXPECT_THAT(refusal("hand.gltf", hand.root.dump()), HasSubstr("at most 12 elements"));
  hand.accessor("indices")["count"] = 12;
  hand.root["skins"][0]["joints"] = {1, 77};
  EXPECT_THAT(refusal("hand.gltf", hand.root.dump()), HasSubstr("skins[0].joints[1]"));
  hand.root["buffers"] = {{{"byteLength", 4}}};
  hand.root["skins"][0]["joints"] = {1, 2};
  EXPECT_THAT(refusal("hand.gltf", hand.root.dump()), HasSubstr("a uri"));
  EXPECT_THAT(refusal("hand.gltf", "{"), HasSubstr("JSON"));
}

}  // namespace
}  // namespace graspdb
