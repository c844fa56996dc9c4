// SPDX-License-Identifier: MIT
#include <assimp/config.h>
#include <fmt/format.h>

#include <map>
#include <set>

#include "fbx_bones.h"
#include "graspdb/core/assimp/assimp_scene.h"
#include "graspdb/core/error.h"
#include "graspdb/core/file.h"
#include "graspdb/core/file_name.h"
#include "reduced_files.h"

namespace graspdb {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestFile = 256 << 20;
constexpr std::size_t kMostVertices = 1 << 25;

void require_limited(const fs::path& file) {
  std::error_code absent;  // who reads it reports that
  const std::uintmax_t size = fs::file_size(file, absent);
  if (!absent && size > kLargestFile) {
    throw Error({file.string(), "", fmt::format("at most {} MiB", kLargestFile >> 20),
                 fmt::format("{} bytes", size)});
  }
}

void import_bytes(Assimp::Importer& importer, const std::string& bytes, const char* format) {
  importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, format);
}

// Of our own, in the metadata of scenes whose file states its unit.
constexpr const char* kUnitKey = "graspdb_metres_per_unit";

// assimp scales a COLLADA file's root by the unit, 1 when there is none. The axes stay the file's.
void import_collada(Assimp::Importer& importer, const std::string& text) {
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  import_bytes(importer, text, "dae");
  aiScene* scene = const_cast<aiScene*>(importer.GetScene());
  if (scene == nullptr || scene->mRootNode == nullptr) return;
  if (text.find("<unit") == text.npos) return;
  if (scene->mMetaData == nullptr) scene->mMetaData = new aiMetadata;  // the scene's own
  scene->mMetaData->Add(kUnitKey, static_cast<double>(scene->mRootNode->mTransformation.a1));
}

void import(Assimp::Importer& importer, const fs::path& file) {
  const std::string extension = lower_extension(file);
  if (extension == ".glb") {
    import_bytes(importer, reduced_glb(read_limited(file), file), "glb");
  } else if (extension == ".gltf") {
    import_bytes(importer, reduced_gltf(read_limited(file), file), "glb");
  } else if (extension == ".dae") {
    import_collada(importer, read_limited(file));
  } else if (extension == ".fbx") {
    const std::string bytes = read_limited(file);
    require_own_bone_names(bytes, file.string());
    import_bytes(importer, bytes, "fbx");
  } else if (extension == ".obj") {
    import_bytes(importer, reduced_obj(read_limited(file), file.string()), "obj");
  } else {
    require_limited(file);
    require_fetched(file);
    importer.ReadFile(file.string(), 0);
  }
}

class SceneCheck {
 public:
  SceneCheck(const aiScene& scene, std::string file) : scene_(scene), file_(std::move(file)) {}

  void run() {
    if (scene_.mRootNode == nullptr) refuse("", "a scene", "none");
    for (unsigned i = 0; i < scene_.mNumMeshes; ++i) {
      check(*scene_.mMeshes[i], fmt::format("mesh {}", i));
    }
    check(*scene_.mRootNode, Eigen::Matrix4d::Identity(), 1);
    for (unsigned i = 0; i < scene_.mNumMeshes; ++i) require_own_names(*scene_.mMeshes[i]);
  }

 private:
  [[noreturn]] void refuse(const std::string& key, const std::string& expected,
                           const std::string& found) const {
    throw Error({file_, key, expected, found});
  }

  void require_index(const std::string& key, std::size_t index, std::size_t count) const {
    if (index >= count) refuse(key, fmt::format("below {}", count), fmt::format("{}", index));
  }

  template <typename Array>
  void require_small(const std::string& key, const Array& values) const {
    if (!(values.abs() <= kLargestCoordinate).all()) {
      refuse(key, fmt::format("numbers up to {:g}", kLargestCoordinate), "others");
    }
  }

  void check(const aiMesh& mesh, const std::string& key) const {
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      require_small(key, Eigen::Array3f::Map(&mesh.mVertices[v].x));
    }
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      for (unsigned i = 0; i < face.mNumIndices; ++i) {
        require_index(key + ", vertex of a face", face.mIndices[i], mesh.mNumVertices);
      }
    }
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
      const aiBone& bone = *mesh.mBones[b];
      require_small(bone.mName.C_Str(), to_eigen(bone.mOffsetMatrix).array());
      for (unsigned i = 0; i < bone.mNumWeights; ++i) {
        require_index(fmt::format("{}, vertex that {} moves", key, bone.mName.C_Str()),
                      bone.mWeights[i].mVertexId, mesh.mNumVertices);
      }
    }
  }

  // A bone's node is found by its name.
  void require_own_names(const aiMesh& mesh) const {
    std::set<std::string> known;
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
      const std::string name = mesh.mBones[b]->mName.C_Str();
      const auto nodes = nodes_.find(name);
      if (nodes != nodes_.end() && nodes->second > 1) {
        refuse(name, "one node of this name, since it is a bone", fmt::format("{}", nodes->second));
      }
      if (!known.insert(name).second) refuse(name, "one bone of this name in a mesh", "another");
    }
  }

  void check(const aiNode& node, const Eigen::Matrix4d& scene_from_parent, std::size_t depth) {
    const std::string name = node.mName.C_Str();
    ++nodes_[name];
    if (depth > kDeepestNode) refuse(name, fmt::format("{} nodes deep", kDeepestNode), "more");
    const Eigen::Matrix4d scene_from_node = scene_from_parent * to_eigen(node.mTransformation);
    require_small(name, scene_from_node.array());
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      require_index(name + ", mesh", node.mMeshes[i], scene_.mNumMeshes);
      vertices_ += scene_.mMeshes[node.mMeshes[i]]->mNumVertices;
    }
    if (vertices_ > kMostVertices) refuse("", fmt::format("{} vertices", kMostVertices), "more");
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
      check(*node.mChildren[i], scene_from_node, depth + 1);
    }
  }

  const aiScene& scene_;
  std::string file_;
  std::size_t vertices_ = 0;
  std::map<std::string, unsigned> nodes_;  // by their names
};

}  // namespace

std::string read_limited(const fs::path& file) {
  require_limited(file);
  return read_text(file);
}

const aiScene& read_scene(Assimp::Importer& importer, const fs::path& file, unsigned steps,
                          const std::string& what) {
  import(importer, file);
  const aiScene* scene = importer.GetScene();
  if (scene != nullptr) {
    SceneCheck(*scene, file.string()).run();
    scene = importer.ApplyPostProcessing(steps);
  }
  if (scene == nullptr || scene->mRootNode == nullptr) {
    throw Error({file.string(), "", what, importer.GetErrorString()});
  }
  return *scene;
}

std::optional<double> stated_meters_per_unit(const aiScene& scene) {
  double meters = 0;
  float centimeters = 0;
  if (scene.mMetaData == nullptr) return std::nullopt;
  if (scene.mMetaData->Get(kUnitKey, meters)) return meters;
  if (scene.mMetaData->Get("UnitScaleFactor", centimeters)) return centimeters / 100;
  return std::nullopt;
}

}  // namespace graspdb
