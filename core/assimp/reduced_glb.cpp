// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <optional>

#include "glb_accessors.h"
#include "graspdb/core/assimp/glb.h"
#include "graspdb/core/error.h"
#include "reduced_files.h"

namespace graspdb {
namespace {

using nlohmann::json;

constexpr std::size_t kLargestJson = 16 << 20;     // bytes
constexpr std::size_t kMostElements = 1 << 25;     // of all that assimp makes of the file
constexpr std::size_t kModes = 7, kTriangles = 4;  // below: points and lines; above: strips, fans

const GlbKind kVectors = {{"VEC3"}, {kFloat}};
const GlbKind kColors = {{"VEC3", "VEC4"}, {kFloat, kUnsignedByte, kUnsignedShort}};
const GlbKind kJoints = {{"VEC4"}, {kUnsignedByte, kUnsignedShort}};
const GlbKind kWeights = {{"VEC4"}, {kFloat}};
const GlbKind kIndices = {{"SCALAR"}, {kUnsignedByte, kUnsignedShort, kUnsignedInt}};
const GlbKind kMatrices = {{"MAT4"}, {kFloat}};

class GlbReducer {
 public:
  GlbReducer(const JsonEntry& root, std::string_view binary)
      : root_(root),
        accessors_(root, binary),
        nodes_(root.items("nodes")),
        parents_(nodes_.size()),
        materials_(root.items("materials").size()),
        binary_(binary) {}

  std::string reduced() {
    json result;
    result["asset"] = reduced_asset();
    result["meshes"] = reduced_all("meshes", &GlbReducer::reduced_mesh);
    result["skins"] = reduced_all("skins", &GlbReducer::reduced_skin);
    result["nodes"] = reduced_all("nodes", &GlbReducer::reduced_node);
    result["scenes"] = {{{"nodes", reduced_scene()}}};
    require_trees();
    // Their number is all that assimp needs to know which meshes share one.
    result["materials"] = json::array_t(materials_, json::object());
    result["accessors"] = accessors_.used();
    result["bufferViews"] = accessors_.used_views();
    result["buffers"] = {{{"byteLength", binary_.size()}}};
    return glb_file(result.dump(), binary_);
  }

 private:
  struct MeshSize {
    std::size_t primitives = 0, elements = 0;
  };

  json::array_t reduced_all(const char* name, json (GlbReducer::*reduce)(const JsonEntry&)) {
    json::array_t all;
    for (const JsonEntry& entry : root_.items(name)) all.push_back((this->*reduce)(entry));
    return all;
  }

  // A small file can name the same thing many times.
  void spend(const JsonEntry& entry, std::size_t elements) {
    spent_ += elements;
    if (spent_ > kMostElements) {
      entry.refuse(fmt::format("at most {} vertices, indices and bones", kMostElements), "more");
    }
  }

  json reduced_asset() const {
    json asset = {{"version", "2.0"}};
    if (root_.at("asset").has("generator")) {
      asset["generator"] = root_.at("asset").at("generator").text();
    }
    return asset;
  }

  json reduced_mesh(const JsonEntry& mesh) {
    json::array_t primitives;
    MeshSize& size = mesh_sizes_.emplace_back();
    for (const JsonEntry& primitive : mesh.items("primitives")) {
      if (primitive.whole_or("mode", kTriangles, kModes) < kTriangles) continue;
      const std::size_t before = spent_;
      primitives.push_back(reduced_primitive(primitive));
      size.primitives += 1;
      size.elements += spent_ - before;
    }
    return {{"primitives", std::move(primitives)}};
  }

  json reduced_primitive(const JsonEntry& primitive) {
    const JsonEntry attributes = primitive.at("attributes");
    const GlbElements places = accessors_.use(attributes.at("POSITION"), kVectors);
    spend(primitive, places.count);
    json result = {{"mode", primitive.whole_or("mode", kTriangles, kModes)},
                   {"attributes", {{"POSITION", places.accessor}}}};
    json& kept = result["attributes"];
    keep("NORMAL", kVectors, attributes, places.count, kept);
    keep("COLOR_0", kColors, attributes, places.count, kept);
    keep_weights(attributes, places.count, kept);
    if (primitive.has("material")) {
      result["material"] = primitive.at("material").whole(materials_);
    }
    std::size_t corners = places.count;
    if (primitive.has("indices")) {
      const GlbElements indices = use_indices(primitive.at("indices"), places.count);
      result["indices"] = indices.accessor;
      corners = indices.count;
    }
    if (corners < 3) primitive.refuse("a triangle or more", "less");
    return result;
  }

  // Four bones of a vertex and their weights in each set.
  void keep_weights(const JsonEntry& attributes, std::size_t vertices, json& kept) {
    GlbKind joints = kJoints;
    for (int set = 0; attributes.has(fmt::format("JOINTS_{}", set)); ++set) {
      const JsonEntry weights = attributes.at(fmt::format("WEIGHTS_{}", set));
      // assimp takes all sets to be of the first one's numbers.
      joints.components = {accessors_.use(attributes.at("JOINTS_0"), joints).component};
      keep(fmt::format("JOINTS_{}", set), joints, attributes, vertices, kept);
      keep(fmt::format("WEIGHTS_{}", set), kWeights, attributes, vertices, kept);
      spend(weights, 4 * vertices);
    }
  }

  // What vertices may have besides their place.
  void keep(const std::string& name, const GlbKind& kind, const JsonEntry& attributes,
            std::size_t vertices, json& kept) {
    if (!attributes.has(name)) return;
    const GlbElements elements = accessors_.use(attributes.at(name), kind);
    if (elements.count != vertices) {
      attributes.at(name).refuse(fmt::format("one of each of {} vertices", vertices),
                                 fmt::format("{}", elements.count));
    }
    kept[name] = elements.accessor;
  }

  GlbElements use_indices(const JsonEntry& entry, std::size_t vertices) {
    const GlbElements indices = accessors_.use(entry, kIndices);
    spend(entry, indices.count);
    for (std::size_t i = 0; i < indices.count; ++i) {
      if (indices.index_at(i) < vertices) continue;
      entry.refuse(fmt::format("vertices below {}", vertices),
                   fmt::format("{}", indices.index_at(i)));
    }
    return indices;
  }

  json reduced_skin(const JsonEntry& skin) {
    json::array_t joints;
    for (const JsonEntry& joint : skin.at("joints").items()) {
      joints.push_back(joint.whole(nodes_.size()));
    }
    const GlbElements binds = accessors_.use(skin.at("inverseBindMatrices"), kMatrices);
    if (binds.count < joints.size()) {
      skin.at("inverseBindMatrices")
          .refuse(fmt::format("one of each of {} joints", joints.size()),
                  fmt::format("{}", binds.count));
    }
    spend(skin, skin_sizes_.emplace_back(binds.count));
    return {{"joints", std::move(joints)}, {"inverseBindMatrices", binds.accessor}};
  }

  json reduced_node(const JsonEntry& node) {
    json result = json::object();
    if (node.has("name")) result["name"] = node.at("name").text();
    const std::size_t index = node_count_++;
    for (const JsonEntry& child : node.items("children")) {
      result["children"].push_back(adopt(child, index));
    }
    for (const auto& [name, size] : {std::pair("matrix", 16), std::pair("translation", 3),
                                     std::pair("rotation", 4), std::pair("scale", 3)}) {
      if (node.has(name)) result[name] = node.at(name).numbers(static_cast<std::size_t>(size));
    }
    if (node.has("mesh")) reduce_use(node, result);
    return result;
  }

  void reduce_use(const JsonEntry& node, json& result) {
    const std::size_t mesh = node.at("mesh").whole(mesh_sizes_.size());
    result["mesh"] = mesh;
    spend(node, mesh_sizes_[mesh].elements);
    if (!node.has("skin")) return;
    const std::size_t skin = node.at("skin").whole(skin_sizes_.size());
    result["skin"] = skin;
    spend(node, mesh_sizes_[mesh].primitives * skin_sizes_[skin]);
  }

  // assimp makes a node anew each time it is named.
  std::size_t adopt(const JsonEntry& child, std::size_t parent) {
    const std::size_t node = child.whole(nodes_.size());
    if (parents_[node]) child.refuse("a node that no other one holds");
    parents_[node] = parent;
    return node;
  }

  json::array_t reduced_scene() {
    const std::vector<JsonEntry> scenes = root_.items("scenes");
    const std::size_t scene = root_.whole_or("scene", 0, scenes.size());
    if (scene >= scenes.size()) root_.refuse("a scene", "none");
    json::array_t roots;
    for (const JsonEntry& node : scenes[scene].items("nodes")) {
      roots.push_back(adopt(node, nodes_.size()));
    }
    return roots;
  }

  // From every node a short way leads up to one that has no parent, or is a scene's.
  void require_trees() const {
    for (std::size_t node = 0; node < nodes_.size(); ++node) {
      std::size_t depth = 1;
      for (auto up = parents_[node]; up && *up < nodes_.size(); up = parents_[*up]) {
        if (++depth > kDeepestNode) {
          nodes_[node].refuse(fmt::format("a tree at most {} nodes deep", kDeepestNode), "another");
        }
      }
    }
  }

  JsonEntry root_;
  GlbAccessors accessors_;
  std::vector<JsonEntry> nodes_;
  std::vector<std::optional<std::size_t>> parents_;  // those of the scene: the number of nodes
  std::size_t materials_;
  std::vector<MeshSize> mesh_sizes_;
  std::vector<std::size_t> skin_sizes_;
  std::size_t node_count_ = 0, spent_ = 0;
  std::string_view binary_;
};

json parsed(std::string_view text, const std::string& file) {
  if (text.size() > kLargestJson) {
    throw Error({file, "JSON chunk", fmt::format("at most {} MiB", kLargestJson >> 20),
                 fmt::format("{} bytes", text.size())});
  }
  try {
    // Some writers pad with zeros where the specification says spaces.
    return json::parse(text.substr(0, text.find_last_not_of('\0') + 1));
  } catch (const json::exception& fault) {
    throw Error({file, "JSON chunk", "JSON", fault.what()});
  }
}

}  // namespace

std::string reduced_glb(std::string_view bytes, const std::string& file) {
  const GlbParts parts = glb_parts(bytes, file);
  const json root = parsed(parts.json, file);
  return GlbReducer(JsonEntry(root, file), parts.binary).reduced();
}

}  // namespace graspdb
