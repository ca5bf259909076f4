#include "sim/world/mesh_builder.h"

#include "core/digest.h"

namespace citrine::sim {
namespace {

constexpr double kDegenerateArea_m2 = 1e-10;

double Area(const TriMesh& mesh, const std::array<int, 3>& t) {
  const Eigen::Vector3d a = mesh.vertices_W[t[0]].cast<double>();
  const Eigen::Vector3d b = mesh.vertices_W[t[1]].cast<double>();
  const Eigen::Vector3d c = mesh.vertices_W[t[2]].cast<double>();
  return 0.5 * (b - a).cross(c - a).norm();
}

}  // namespace

void AddPart(const TriMesh& mesh_M, const Eigen::Affine3d& X_WM, const Part& part, World& world) {
  TriMesh& mesh = world.mesh;
  const int first_vertex = static_cast<int>(mesh.vertices_W.size());
  for (const Eigen::Vector3f& v_M : mesh_M.vertices_W) {
    const Eigen::Vector3f v_W = (X_WM * v_M.cast<double>()).cast<float>();
    if (!v_W.allFinite()) throw WorldError(part.name + ": a vertex of its mesh is not a finite number");
    mesh.vertices_W.push_back(v_W);
  }
  Part added = part;
  added.first_triangle = static_cast<int>(mesh.triangles.size());
  const bool mirrored = X_WM.linear().determinant() < 0;
  for (std::array<int, 3> triangle : mesh_M.triangles) {
    for (int& corner : triangle) corner += first_vertex;
    if (mirrored) std::swap(triangle[1], triangle[2]);
    if (Area(mesh, triangle) > kDegenerateArea_m2) mesh.triangles.push_back(triangle);
  }
  added.num_triangles = static_cast<int>(mesh.triangles.size()) - added.first_triangle;
  if (added.num_triangles > 0) world.parts.push_back(added);
}

void Finish(const std::string& path, World& world) {
  if (world.mesh.triangles.empty()) throw WorldError(path + ": there is no surface in it");
  world.bounds_W.setEmpty();
  for (const auto& triangle : world.mesh.triangles)
    for (const int corner : triangle) world.bounds_W.extend(world.mesh.vertices_W[corner].cast<double>());
  Digest digest;
  digest.Add(world.mesh.vertices_W.data(), world.mesh.vertices_W.size() * sizeof(Eigen::Vector3f));
  digest.Add(world.mesh.triangles.data(), world.mesh.triangles.size() * sizeof(std::array<int, 3>));
  world.hash = digest.value();
}

const Part& World::PartOf(int triangle) const {
  auto after = std::upper_bound(parts.begin(), parts.end(), triangle,
                                [](int t, const Part& part) { return t < part.first_triangle; });
  return *std::prev(after);
}

double World::SurfaceArea() const {
  double area_m2 = 0;
  for (const auto& triangle : mesh.triangles) area_m2 += Area(mesh, triangle);
  return area_m2;
}

}  // namespace citrine::sim
