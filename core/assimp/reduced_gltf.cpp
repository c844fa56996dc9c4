// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "gltf_accessors.h"
#include "gltf_json.h"
#include "graspdb/core/assimp/glb.h"
#include "reduced_files.h"

namespace graspdb {
namespace {

using nlohmann::json;

constexpr std::size_t kMostElements = 1 << 25;     // of all that assimp makes of the file
constexpr std::size_t kModes = 7, kTriangles = 4;  // below: points and lines; above: strips, fans

const GltfKind kVectors = {
    {"VEC3"}, {kFloat, kByte, kUnsignedByte, kShort, kUnsignedShort}, kFloat};
const GltfKind kColors = {{"VEC3", "VEC4"}, {kFloat, kUnsignedByte, kUnsignedShort}, kFloat, true};
const GltfKind kJoints = {{"VEC4"}, {kUnsignedByte, kUnsignedShort}, kUnsignedShort};
const GltfKind kWeights = {{"VEC4"}, {kFloat, kUnsignedByte, kUnsignedShort}, kFloat, true};
const GltfKind kIndices = {{"SCALAR"}, {kUnsignedByte, kUnsignedShort, kUnsignedInt}, kUnsignedInt};
const GltfKind kMatrices = {{"MAT4"}, {kFloat}, kFloat};

class GltfReducer {
 public:
  GltfReducer(const JsonEntry& root, GltfBuffers& buffers)
      : root_(root),
        accessors_(root, buffers),
        nodes_(root.items("nodes")),
        parents_(nodes_.size()),
        materials_(root.items("materials").size()) {}

  std::string reduced() {
    json result;
    result["asset"] = reduced_asset();
    result["meshes"] = reduced_all("meshes", &GltfReducer::reduced_mesh);
    result["skins"] = reduced_all("skins", &GltfReducer::reduced_skin);
    result["nodes"] = reduced_all("nodes", &GltfReducer::reduced_node);
    result["scenes"] = {{{"nodes", reduced_scene()}}};
    require_trees();
    require_own_names(result["nodes"]);
    // Their number is all that assimp needs to know which meshes share one.
    result["materials"] = json::array_t(materials_, json::object());
    result["accessors"] = accessors_.written();
    result["bufferViews"] = accessors_.written_views();
    result["buffers"] = {{{"byteLength", accessors_.binary().size()}}};
    return glb_file(result.dump(), accessors_.binary());
  }

 private:
  struct MeshFacts {
    std::size_t primitives = 0, elements = 0;
    std::size_t joints = 0;  // of a skin that the vertices need
    std::size_t uses = 0;
    bool has_skin = false;
  };

  json::array_t reduced_all(const char* name, json (GltfReducer::*reduce)(const JsonEntry&)) {
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
    MeshFacts& facts = meshes_.emplace_back();
    require_no_morph(mesh);
    for (const JsonEntry& primitive : mesh.items("primitives")) {
      if (primitive.whole_or("mode", kTriangles, kModes) < kTriangles) continue;
      const std::size_t before = spent_;
      primitives.push_back(reduced_primitive(primitive));
      facts.primitives += 1;
      facts.elements += spent_ - before;
    }
    return {{"primitives", std::move(primitives)}};
  }

  json reduced_primitive(const JsonEntry& primitive) {
    const JsonEntry attributes = primitive.at("attributes");
    const GltfNumbers places = accessors_.use(attributes.at("POSITION"), kVectors);
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
      const GltfNumbers indices = use_indices(primitive.at("indices"), places.count);
      result["indices"] = indices.accessor;
      corners = indices.count;
    }
    if (corners < 3) primitive.refuse("a triangle or more", "less");
    return result;
  }

  // Four bones of a vertex and their weights in each set.
  void keep_weights(const JsonEntry& attributes, std::size_t vertices, json& kept) {
    for (int set = 0; attributes.has(fmt::format("JOINTS_{}", set)); ++set) {
      const std::string joints = fmt::format("JOINTS_{}", set);
      const JsonEntry weights = attributes.at(fmt::format("WEIGHTS_{}", set));
      const double largest = keep(joints, kJoints, attributes, vertices, kept);
      meshes_.back().joints =
          std::max(meshes_.back().joints, static_cast<std::size_t>(largest) + 1);
      keep(fmt::format("WEIGHTS_{}", set), kWeights, attributes, vertices, kept);
      spend(weights, 4 * vertices);
    }
  }

  // What vertices may have besides their place. Returns the largest number of it.
  double keep(const std::string& name, const GltfKind& kind, const JsonEntry& attributes,
              std::size_t vertices, json& kept) {
    if (!attributes.has(name)) return 0;
    const GltfNumbers numbers = accessors_.use(attributes.at(name), kind);
    if (numbers.count != vertices) {
      attributes.at(name).refuse(fmt::format("one of each of {} vertices", vertices),
                                 fmt::format("{}", numbers.count));
    }
    kept[name] = numbers.accessor;
    return numbers.largest;
  }

  GltfNumbers use_indices(const JsonEntry& entry, std::size_t vertices) {
    const GltfNumbers indices = accessors_.use(entry, kIndices);
    spend(entry, indices.count);
    if (!(indices.largest < static_cast<double>(vertices))) {
      entry.refuse(fmt::format("vertices below {}", vertices), fmt::format("{}", indices.largest));
    }
    return indices;
  }

  json reduced_skin(const JsonEntry& skin) {
    json::array_t joints;
    std::set<std::size_t> known;
    for (const JsonEntry& joint : skin.at("joints").items()) {
      const std::size_t node = joint.whole(nodes_.size());
      if (!known.insert(node).second) joint.refuse("a node that is no joint of the skin yet");
      joints.push_back(node);
    }
    joints_.merge(known);
    skin_sizes_.push_back(joints.size());
    spend(skin, joints.size());
    const std::size_t binds = reduced_binds(skin, joints.size());
    return {{"joints", std::move(joints)}, {"inverseBindMatrices", binds}};
  }

  // Where a file has none, they are identities; assimp reads through a null pointer then.
  std::size_t reduced_binds(const JsonEntry& skin, std::size_t joints) {
    if (!skin.has("inverseBindMatrices")) return accessors_.write_identities(joints);
    const JsonEntry entry = skin.at("inverseBindMatrices");
    const GltfNumbers binds = accessors_.use(entry, kMatrices);
    if (binds.count < joints) {
      entry.refuse(fmt::format("one of each of {} joints", joints), fmt::format("{}", binds.count));
    }
    spend(entry, binds.count);
    return binds.accessor;
  }

  json reduced_node(const JsonEntry& node) {
    const std::size_t index = node_count_++;
    require_no_morph(node);
    const std::string name = node.has("name") ? node.at("name").text() : "";
    // assimp would call a joint without a name one thing as a node, and another as a bone.
    json result = {{"name", name.empty() ? fmt::format("node_{}", index) : name}};
    for (const JsonEntry& child : node.items("children")) {
      result["children"].push_back(adopt(child, index));
    }
    for (const auto& [part, size] : {std::pair("matrix", 16), std::pair("translation", 3),
                                     std::pair("rotation", 4), std::pair("scale", 3)}) {
      if (node.has(part)) result[part] = node.at(part).numbers(static_cast<std::size_t>(size));
    }
    if (node.has("mesh")) reduce_use(node, result);
    return result;
  }

  void reduce_use(const JsonEntry& node, json& result) {
    const std::size_t mesh = node.at("mesh").whole(meshes_.size());
    MeshFacts& facts = meshes_[mesh];
    result["mesh"] = mesh;
    spend(node, facts.elements);
    if (node.has("skin")) reduce_skin_use(node, facts, result);
    // assimp keeps the bones with the mesh, where the second node's would replace the first one's.
    if (++facts.uses > 1 && facts.has_skin) {
      node.at("mesh").refuse("a mesh that no other node shows, since a skin moves it");
    }
  }

  void reduce_skin_use(const JsonEntry& node, MeshFacts& facts, json& result) {
    const std::size_t skin = node.at("skin").whole(skin_sizes_.size());
    result["skin"] = skin;
    facts.has_skin = true;
    spend(node, facts.primitives * skin_sizes_[skin]);
    if (facts.joints > skin_sizes_[skin]) {
      node.at("skin").refuse(fmt::format("{} joints or more, as its mesh names", facts.joints),
                             fmt::format("{}", skin_sizes_[skin]));
    }
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

  // assimp finds the node of a bone by its name.
  void require_own_names(const json& nodes) const {
    std::map<std::string, std::size_t> uses;
    for (const json& node : nodes) ++uses[node["name"].get<std::string>()];
    for (const std::size_t joint : joints_) {
      const std::string name = nodes[joint]["name"].get<std::string>();
      if (uses[name] == 1) continue;
      nodes_[joint].refuse("a name that no other node has, since it is a joint of a skin",
                           fmt::format("{} of the name {}", uses[name], name));
    }
  }

  JsonEntry root_;
  GltfAccessors accessors_;
  std::vector<JsonEntry> nodes_;
  std::vector<std::optional<std::size_t>> parents_;  // those of the scene: the number of nodes
  std::size_t materials_;
  std::vector<MeshFacts> meshes_;
  std::vector<std::size_t> skin_sizes_;
  std::set<std::size_t> joints_;  // nodes
  std::size_t node_count_ = 0, spent_ = 0;
};

std::string reduced(const json& document, const std::filesystem::path& file,
                    std::optional<std::string_view> binary) {
  const JsonEntry root(document, file.string());
  GltfBuffers buffers(root, file.parent_path(), binary);
  return GltfReducer(root, buffers).reduced();
}

}  // namespace

std::string reduced_glb(std::string_view bytes, const std::filesystem::path& file) {
  const GlbParts parts = glb_parts(bytes, file.string());
  return reduced(parsed_gltf(parts.json, file.string(), kLargestGlbJson), file, parts.binary);
}

std::string reduced_gltf(std::string_view text, const std::filesystem::path& file) {
  return reduced(parsed_gltf(text, file.string(), kLargestGltfJson), file, std::nullopt);
}

}  // namespace graspdb
