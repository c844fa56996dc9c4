// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "graspdb/core/assimp/glb.h"

namespace graspdb::testing {

// Numbers of the glTF specification.
constexpr int kSignedBytes = 5120, kBytes = 5121, kSignedShorts = 5122, kShorts = 5123,
              kFloats = 5126;

template <typename T>
std::string bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

// A tetrahedron of 20 units that two bones move.
struct TinyHand {
  nlohmann::json root;
  std::string binary;

  TinyHand() {
    root = nlohmann::json::parse(R"({"asset": {"version": "2.0", "generator": "a test"},
      "scenes": [{"nodes": [0, 1]}],
      "nodes": [{"mesh": 0, "skin": 0}, {"name": "wrist", "children": [2]},
                {"name": "tip", "translation": [0, 0, 10]}],
      "skins": [{"joints": [1, 2]}], "meshes": [{"primitives": [{}]}],
      "accessors": [], "bufferViews": []})");
    nlohmann::json& primitive = root["meshes"][0]["primitives"][0];
    primitive["attributes"]["POSITION"] =
        add<float>({0, 0, 0, 20, 0, 0, 0, 20, 0, 0, 0, 20}, kFloats, 4, "VEC3");
    primitive["attributes"]["JOINTS_0"] =
        add<std::uint8_t>(std::vector<std::uint8_t>(16, 1), kBytes, 4, "VEC4");
    primitive["attributes"]["WEIGHTS_0"] =
        add<float>({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, kFloats, 4, "VEC4");
    primitive["indices"] =
        add<std::uint8_t>({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}, kBytes, 12, "SCALAR");
    const std::vector<float> identity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    std::vector<float> binds = identity;
    binds.insert(binds.end(), identity.begin(), identity.end());
    root["skins"][0]["inverseBindMatrices"] = add(binds, kFloats, 2, "MAT4");
  }

  template <typename T>
  std::size_t add(const std::vector<T>& values, int component, std::size_t count,
                  const std::string& type) {
    const std::size_t offset = binary.size();
    binary += bytes_of(values);
    root["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", binary.size() - offset}});
    binary.resize((binary.size() + 3) / 4 * 4);
    root["accessors"].push_back({{"bufferView", root["bufferViews"].size() - 1},
                                 {"componentType", component},
                                 {"count", count},
                                 {"type", type}});
    return root["accessors"].size() - 1;
  }

  nlohmann::json& primitive() { return root["meshes"][0]["primitives"][0]; }
  // By the attribute, or "indices".
  nlohmann::json& accessor(const std::string& name) {
    const nlohmann::json& from = name == "indices" ? primitive() : primitive()["attributes"];
    return root["accessors"][from[name].get<std::size_t>()];
  }
  nlohmann::json& view(const std::string& name) {
    return root["bufferViews"][accessor(name)["bufferView"].get<std::size_t>()];
  }

  std::string glb() const { return glb_file(root.dump(), binary); }
};

}  // namespace graspdb::testing
