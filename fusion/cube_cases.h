#pragma once

#include <array>
#include <vector>

namespace citrine::fusion {

// Corners of a cube: bit 0 is x, bit 1 y, bit 2 z. Edges: the lower of its two corners, and an axis.

/// An edge of the cube: from `corner` along `axis`.
struct CubeEdge {
  int corner, axis;
  bool operator==(const CubeEdge&) const = default;
};
using CubeTriangle = std::array<CubeEdge, 3>;

/// The triangles of marching cubes for each of the 256 sets of corners inside (Lorensen & Cline 1987),
/// derived rather than tabulated: every face cuts off its runs of inside corners, so that neighbouring cubes
/// always agree and the surface is closed (the ambiguous faces, too). Counter-clockwise seen from outside.
const std::array<std::vector<CubeTriangle>, 256>& CubeCases();

}  // namespace citrine::fusion
