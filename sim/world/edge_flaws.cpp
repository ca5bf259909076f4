#include "sim/world/edge_flaws.h"

#include <cstdio>
#include <map>
#include <utility>

namespace citrine::sim {
namespace {

using Place = std::array<float, 3>;

/// How often the triangles of a part walk along an edge, from its lower end and from its upper.
struct Walks {
  int up = 0, down = 0;
};
using Edges = std::map<std::pair<Place, Place>, Walks>;

Place PlaceOf(const Eigen::Vector3f& p_W) { return {p_W.x(), p_W.y(), p_W.z()}; }

Edges EdgesOf(const World& world, const Part& part) {
  Edges edges;
  for (int t = part.first_triangle; t < part.first_triangle + part.num_triangles; ++t)
    for (int corner = 0; corner < 3; ++corner) {
      const auto& triangle = world.mesh.triangles[static_cast<std::size_t>(t)];
      const Place from = PlaceOf(world.mesh.vertices_W[static_cast<std::size_t>(triangle[corner])]);
      const Place to = PlaceOf(world.mesh.vertices_W[static_cast<std::size_t>(triangle[(corner + 1) % 3])]);
      if (from < to)
        ++edges[{from, to}].up;
      else
        ++edges[{to, from}].down;
    }
  return edges;
}

/// [m^3] by the divergence theorem, of a closed surface.
double EnclosedVolume(const World& world, const Part& part) {
  double six_volumes = 0;
  for (int t = part.first_triangle; t < part.first_triangle + part.num_triangles; ++t) {
    const auto& [a, b, c] = world.mesh.triangles[static_cast<std::size_t>(t)];
    const auto corner = [&](int i) -> Eigen::Vector3d {
      return world.mesh.vertices_W[static_cast<std::size_t>(i)].cast<double>();
    };
    six_volumes += corner(a).dot(corner(b).cross(corner(c)));
  }
  return six_volumes / 6;
}

std::string Where(const Part& part, const Place& p_W) {
  char place[96];
  std::snprintf(place, sizeof place, " near (%.2f, %.2f, %.2f)", p_W[0], p_W[1], p_W[2]);
  return part.name + place;
}

}  // namespace

EdgeFlaws FindEdgeFlaws(const World& world) {
  EdgeFlaws flaws;
  for (const Part& part : world.parts) {
    if (part.ground || part.half_space) continue;
    bool sound = true;
    for (const auto& [edge, walks] : EdgesOf(world, part)) {
      const bool open = (walks.up + walks.down) % 2 == 1;
      if (!open && walks.up == walks.down) continue;
      sound = false;
      if (++(open ? flaws.open : flaws.against) == 1)
        (open ? flaws.open_at : flaws.against_at) = Where(part, edge.first);
    }
    if (sound && EnclosedVolume(world, part) < 0 && ++flaws.inside_out == 1) flaws.inside_out_at = part.name;
  }
  return flaws;
}

}  // namespace citrine::sim
