#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "sim/world/mesh_builder.h"
#include "sim/world/primitives.h"
#include "sim/world/world.h"

namespace citrine::sim {

/// A world of solid boxes; those named "ground" are ground.
inline World BoxWorld(const std::vector<std::pair<std::string, Eigen::AlignedBox3d>>& boxes) {
  World world;
  world.name = "boxes";
  for (const auto& [name, box] : boxes) {
    Part part;
    part.name = name;
    part.ground = name == "ground";
    AddPart(BoxMesh(box.sizes()), Eigen::Affine3d(Eigen::Translation3d(box.center())), part, world);
  }
  Finish("boxes", world);
  return world;
}

inline Eigen::AlignedBox3d Box(double x0, double y0, double z0, double x1, double y1, double z1) {
  return {Eigen::Vector3d(x0, y0, z0), Eigen::Vector3d(x1, y1, z1)};
}

}  // namespace citrine::sim
