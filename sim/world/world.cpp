#include "sim/world/world.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>

#include "sim/world/mesh_builder.h"
#include "sim/world/mesh_reader.h"
#include "sim/world/sdf_reader.h"

namespace citrine::sim {
namespace {

namespace fs = std::filesystem;

constexpr double kGroundBand_m = 0.05;    ///< the ground of a bare mesh lies this close to its lowest point
constexpr double kGroundNormalZ = 0.966;  ///< and is level to within 15 degrees
constexpr double kVolumeMargin_m = 3;

bool IsGround(const TriMesh& mesh, const std::array<int, 3>& triangle, float lowest_m) {
  const Eigen::Vector3f &a = mesh.vertices_W[triangle[0]], &b = mesh.vertices_W[triangle[1]],
                        &c = mesh.vertices_W[triangle[2]];
  const Eigen::Vector3f normal = (b - a).cross(c - a);
  return std::max({a.z(), b.z(), c.z()}) <= lowest_m + kGroundBand_m &&
         std::abs(normal.z()) >= kGroundNormalZ * normal.norm();
}

/// One part a mesh, and its ground's triangles as a part of their own.
World ReadBareMesh(const std::string& path) {
  World world;
  world.name = fs::path(path).stem().string();
  const std::vector<NamedMesh> pieces = ReadMeshFile(path);
  float lowest_m = std::numeric_limits<float>::infinity();
  for (const NamedMesh& piece : pieces)
    for (const auto& triangle : piece.mesh.triangles)
      for (const int corner : triangle) lowest_m = std::min(lowest_m, piece.mesh.vertices_W[corner].z());
  for (const NamedMesh& piece : pieces) {
    TriMesh ground = piece.mesh, rest = piece.mesh;
    const auto is_ground = [&](const auto& triangle) { return IsGround(piece.mesh, triangle, lowest_m); };
    std::erase_if(ground.triangles, [&](const auto& triangle) { return !is_ground(triangle); });
    std::erase_if(rest.triangles, is_ground);
    const std::string name = piece.name.empty() ? world.name : piece.name;
    if (!ground.triangles.empty())
      AddPart(ground, Eigen::Affine3d::Identity(), {name + "/ground", 0, 0, true, false}, world);
    if (!rest.triangles.empty())
      AddPart(rest, Eigen::Affine3d::Identity(), {name, 0, 0, false, false}, world);
  }
  return world;
}

}  // namespace

World LoadWorld(const std::string& path, const std::vector<std::string>& search) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) throw WorldError(path + ": there is no such file");
  std::string extension = fs::path(path).extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  World world;
  if (extension == ".sdf" || extension == ".world") {
    const fs::path folder = fs::absolute(path).lexically_normal().parent_path();
    std::vector<std::string> folders{folder.string(), (folder / "models").string(),
                                     folder.parent_path().string()};
    folders.insert(folders.end(), search.begin(), search.end());
    world = ReadSdf(path, folders);
  } else {
    world = ReadBareMesh(path);
  }
  Finish(path, world);
  return world;
}

Eigen::AlignedBox3d DefaultVolume(const World& world) {
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(kVolumeMargin_m);
  return {world.bounds_W.min() - margin, world.bounds_W.max() + margin};
}

}  // namespace citrine::sim
