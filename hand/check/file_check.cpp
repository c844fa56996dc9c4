// SPDX-License-Identifier: MIT
#include <assimp/commonMetaData.h>
#include <fmt/format.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <map>

#include "graspdb/core/assimp/assimp_scene.h"
#include "graspdb/core/error.h"
#include "graspdb/hand/check/hand_file_check.h"
#include "lines.h"

namespace graspdb {
namespace {

const aiScene& read(Assimp::Importer& importer, const std::filesystem::path& file) {
  return read_scene(importer, file, 0, "a rigged hand");
}

Eigen::Matrix4d file_from_node(const aiNode* node) {
  Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
  for (; node != nullptr; node = node->mParent) pose = to_eigen(node->mTransformation) * pose;
  return pose;
}

const aiNode* holder_of(unsigned mesh, const aiNode* node) {
  const unsigned *begin = node->mMeshes, *end = begin + node->mNumMeshes;
  if (std::find(begin, end, mesh) != end) return node;
  for (unsigned i = 0; i < node->mNumChildren; ++i) {
    if (const aiNode* found = holder_of(mesh, node->mChildren[i])) return found;
  }
  return nullptr;
}

double largest_side(const aiMesh& mesh) {
  Eigen::Array3d low = Eigen::Array3d::Constant(1e300), high = -low;
  for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
    const Eigen::Array3d point(mesh.mVertices[v].x, mesh.mVertices[v].y, mesh.mVertices[v].z);
    low = low.min(point), high = high.max(point);
  }
  return (high - low).maxCoeff();
}

class FileCheck {
 public:
  explicit FileCheck(const aiScene& scene) : scene_(scene) {
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) add_mesh(i);
  }

  bool has_skin() const { return has_skin_; }

  std::vector<HandCheckLine> lines() const {
    return {judged("weight sum", sum_.value, "", at_most(1e-5), sum_.where),
            judged("least weight", -least_.value, "", at_least(0), least_.where),
            judged("bones a vertex", bones_.value, "", at_most(4), bones_.where),
            judged("bind identity", bind_.value, "", at_most(1e-5), bind_.where)};
  }

 private:
  struct Vertex {
    double sum = 0;
    int bones = 0;
  };

  void add_mesh(unsigned index) {
    const aiMesh& mesh = *scene_.mMeshes[index];
    if (mesh.mNumBones == 0) return;
    has_skin_ = true;
    std::vector<Vertex> vertices(mesh.mNumVertices);
    for (unsigned b = 0; b < mesh.mNumBones; ++b) add_weights(*mesh.mBones[b], vertices);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      const auto place = [&] { return fmt::format("vertex {}", v); };
      sum_.take(std::abs(vertices[v].sum - 1), place);
      bones_.take(vertices[v].bones, place);
    }
    add_bind(index);
  }

  void add_weights(const aiBone& bone, std::vector<Vertex>& vertices) {
    constexpr double kIdle = 1e-6;
    for (unsigned i = 0; i < bone.mNumWeights; ++i) {
      const unsigned v = bone.mWeights[i].mVertexId;
      const float weight = bone.mWeights[i].mWeight;
      if (weight == 0) continue;
      vertices[v].sum += weight;
      vertices[v].bones += weight > kIdle;
      least_.take(-weight, [&] { return fmt::format("vertex {}, {}", v, bone.mName.C_Str()); });
    }
  }

  // The bind is held to whichever of its two legal values it is nearer to.
  void add_bind(unsigned index) {
    const aiMesh& mesh = *scene_.mMeshes[index];
    const Eigen::Matrix4d holder = file_from_node(holder_of(index, scene_.mRootNode));
    const Worst to_identity = bind_error(mesh, Eigen::Matrix4d::Identity());
    const Worst to_holder = bind_error(mesh, holder);
    const Worst& nearer = to_holder.value < to_identity.value ? to_holder : to_identity;
    bind_.take(nearer.value, [&] { return nearer.where; });
  }

  Worst bind_error(const aiMesh& mesh, const Eigen::Matrix4d& expected) const {
    const double side = largest_side(mesh);
    Worst worst;
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
      const aiBone& bone = *mesh.mBones[b];
      const aiNode* node = scene_.mRootNode->FindNode(bone.mName);
      Eigen::Matrix4d apart =
          expected.inverse() * file_from_node(node) * to_eigen(bone.mOffsetMatrix);
      apart -= Eigen::Matrix4d::Identity();
      apart.topRightCorner<3, 1>() /= side;
      worst.take(apart.cwiseAbs().maxCoeff(), [&] { return std::string(bone.mName.C_Str()); });
    }
    return worst;
  }

  const aiScene& scene_;
  bool has_skin_ = false;
  Worst sum_, least_{-1, {}}, bones_, bind_;
};

}  // namespace

std::vector<HandCheckLine> check_hand_file(const std::filesystem::path& hand_file) {
  Assimp::Importer importer;
  const FileCheck check(read(importer, hand_file));
  if (!check.has_skin()) throw Error({hand_file.string(), "", "a skinned mesh", "none"});
  return check.lines();
}

std::string hand_file_generator(const std::filesystem::path& hand_file) {
  Assimp::Importer importer;
  aiString generator;
  const aiMetadata* facts = read(importer, hand_file).mMetaData;
  if (facts == nullptr || !facts->Get(AI_METADATA_SOURCE_GENERATOR, generator)) return "";
  return generator.C_Str();
}

}  // namespace graspdb
