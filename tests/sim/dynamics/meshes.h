#pragma once

#include "core/map/tri_mesh.h"

namespace citrine::sim {

/// A wall in the plane x = `x_m`, 40 m wide and high, whose triangles face -x or, `flipped`, +x.
inline TriMesh Wall(float x_m, bool flipped = false) {
  TriMesh mesh;
  mesh.vertices_W = {{x_m, -20, -20}, {x_m, 20, -20}, {x_m, 20, 20}, {x_m, -20, 20}};
  mesh.triangles = {{0, 2, 1}, {0, 3, 2}};
  if (flipped) mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

}  // namespace citrine::sim
