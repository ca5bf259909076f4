#include "sim/world/mesh_reader.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include "sim/world/world.h"

namespace citrine::sim {
namespace {

/// Assimp brings every COLLADA file to y up, and glTF is so by definition.
bool ComesYUp(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extension == ".dae" || extension == ".zae" || extension == ".gltf" || extension == ".glb";
}

TriMesh ToTriMesh(const aiMesh& mesh, const aiMatrix4x4& X_FM, bool y_up) {
  TriMesh out;
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const aiVector3D v = X_FM * mesh.mVertices[i];
    out.vertices_W.push_back(y_up ? Eigen::Vector3f(v.x, -v.z, v.y) : Eigen::Vector3f(v.x, v.y, v.z));
  }
  const bool mirrored = X_FM.Determinant() < 0;
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    if (face.mNumIndices != 3) continue;
    std::array<int, 3> t{static_cast<int>(face.mIndices[0]), static_cast<int>(face.mIndices[1]),
                         static_cast<int>(face.mIndices[2])};
    if (mirrored) std::swap(t[1], t[2]);
    out.triangles.push_back(t);
  }
  return out;
}

/// Collects the meshes of a node and of those below it, placed in the file's frame F.
void Collect(const aiScene& scene, const aiNode& node, const aiMatrix4x4& X_FP,
             std::vector<std::string> nodes, bool y_up, std::vector<NamedMesh>& meshes) {
  const aiMatrix4x4 X_FN = X_FP * node.mTransformation;
  nodes.emplace_back(node.mName.C_Str());
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[i]];
    NamedMesh named{mesh.mName.C_Str(), nodes, ToTriMesh(mesh, X_FN, y_up)};
    if (!named.mesh.triangles.empty()) meshes.push_back(std::move(named));
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i)
    Collect(scene, *node.mChildren[i], X_FN, nodes, y_up, meshes);
}

}  // namespace

std::vector<NamedMesh> ReadMeshFile(const std::string& path) {
  Assimp::Importer importer;
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, aiComponent_NORMALS |
                                                          aiComponent_TANGENTS_AND_BITANGENTS |
                                                          aiComponent_COLORS | aiComponent_TEXCOORDS);
  const aiScene* scene = importer.ReadFile(
      path, aiProcess_Triangulate | aiProcess_RemoveComponent | aiProcess_JoinIdenticalVertices);
  if (!scene || !scene->mRootNode)
    throw WorldError(path + ": cannot be read as a mesh: " + importer.GetErrorString());
  std::vector<NamedMesh> meshes;
  Collect(*scene, *scene->mRootNode, aiMatrix4x4(), {}, ComesYUp(path), meshes);
  if (meshes.empty()) throw WorldError(path + ": there is no triangle in it");
  return meshes;
}

}  // namespace citrine::sim
