#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/map/tri_mesh.h"

namespace citrine::sim {

/// A world that cannot be used: one line with what is wrong and where (file, model, link, UAV).
struct WorldError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A run of triangles that came from one collision or visual of a file.
struct Part {
  std::string name;  ///< model/link/shape
  int first_triangle = 0;
  int num_triangles = 0;
  bool ground =
      false;  ///< of a model named "ground..." in any case; of a bare mesh: its lowest level surface
  bool half_space = false;  ///< a plane: everything below it counts as solid
};

/// The true world: one triangle mesh, fixed for the whole mission.
struct World {
  std::string name;
  TriMesh mesh;
  std::vector<Part> parts;       ///< in order of their triangles, which they cover without gaps
  Eigen::AlignedBox3d bounds_W;  ///< [m]
  std::uint64_t hash = 0;        ///< XXH64 over vertices and triangles

  /// The part that a triangle belongs to.
  const Part& PartOf(int triangle) const;
  /// [m^2] area of every triangle together
  double SurfaceArea() const;
};

/// Reads a world: SDFormat (.sdf, .world; shapes, meshes, nested models, includes) or a bare mesh file (.obj
/// .ply .stl .dae ...), which is taken to be in metres, z up, unless the file itself says otherwise.
/// @param search  further folders in which model://NAME is looked for, after the file's own and its models/
/// @throws WorldError
World LoadWorld(const std::string& path, const std::vector<std::string>& search = {});

/// Mission volume of a world that comes without one: its bounds and 3 m on every side.
Eigen::AlignedBox3d DefaultVolume(const World& world);

}  // namespace citrine::sim
