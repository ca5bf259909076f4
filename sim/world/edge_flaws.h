#pragma once

#include <string>

#include "sim/world/world.h"

namespace citrine::sim {

/// What the edges of a world's solids say of its surface; vertices at one place count as one vertex. A ground
/// and planes may be sheets, and are left out.
struct EdgeFlaws {
  int open = 0;        ///< edges of an odd number of triangles: a hole, or the rim of a sheet
  int against = 0;     ///< edges whose triangles are wound against each other
  int inside_out = 0;  ///< closed parts that enclose a negative volume
  std::string open_at, against_at,
      inside_out_at;  ///< where the first of each is: part and, of an edge, place
};
EdgeFlaws FindEdgeFlaws(const World& world);

}  // namespace citrine::sim
