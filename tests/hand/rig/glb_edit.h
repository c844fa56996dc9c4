// SPDX-License-Identifier: MIT
// The male hand's file, taken apart and put together again.
#pragma once

#include <nlohmann/json.hpp>

#include "graspdb/core/assimp/glb.h"
#include "rig_maps.h"

namespace graspdb::testing {

struct GlbEdit {
  nlohmann::json json;
  std::string binary;

  GlbEdit() {
    const std::string bytes = read_text(kMale);
    const GlbParts parts = glb_parts(bytes, kMale.string());
    json = nlohmann::json::parse(parts.json);
    binary = parts.binary;
  }

  std::size_t node(const std::string& name) const {
    for (std::size_t i = 0; i < json["nodes"].size(); ++i) {
      if (json["nodes"][i]["name"] == name) return i;
    }
    throw std::out_of_range(name);
  }

  // Adds a node below another one, or to the scene when `parent` is empty; returns its number.
  std::size_t add_node(const nlohmann::json& node_to_add, const std::string& parent) {
    const std::size_t added = json["nodes"].size();
    json["nodes"].push_back(node_to_add);
    nlohmann::json& holder =
        parent.empty() ? json["scenes"][0]["nodes"] : json["nodes"][node(parent)]["children"];
    holder.push_back(added);
    return added;
  }

  // Adds numbers of one type; returns the accessor's number.
  template <typename T>
  std::size_t add_accessor(const std::vector<T>& values, int component, const std::string& type,
                           std::size_t columns) {
    const std::size_t bytes = values.size() * sizeof(T);
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes}});
    binary.append(reinterpret_cast<const char*>(values.data()), bytes);
    json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                 {"componentType", component},
                                 {"type", type},
                                 {"count", values.size() / columns}});
    return json["accessors"].size() - 1;
  }

  void write(const std::filesystem::path& file) {
    json["buffers"][0]["byteLength"] = binary.size();
    write_text(file, glb_file(json.dump(), binary));
  }

  Hand load(const std::string& map = read_text(rig_map_beside(kMale))) {
    const TemporaryDirectory directory;
    write(directory / "edited.glb");
    return load_with(map, directory / "edited.glb");
  }

  // What loading says to it.
  std::string refusal(const std::string& map = read_text(rig_map_beside(kMale))) {
    try {
      load(map);
    } catch (const Error& error) {
      return error.what();
    }
    return "accepted";
  }
};

}  // namespace graspdb::testing
