#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <citrine_lcm/octree_t.hpp>

namespace citrine {

/// OctoMap's binary stream of the occupancy view, as a .bt file holds it.
struct OctreeBytes {
  std::int64_t map_version = 0;
  double resolution_m = 0;
  std::vector<std::uint8_t> bytes;
};

/// Cuts an octree into messages of at most 33 kB.
std::vector<citrine_lcm::octree_t> EncodeInMessages(const OctreeBytes& octree);

/// Puts an octree together again; one that misses a chunk gives way to the next.
class OctreeAssembler {
 public:
  /// @return the octree when this was its last missing chunk
  /// @throws BadMessage for chunks that do not fit together
  std::optional<OctreeBytes> Add(const citrine_lcm::octree_t& message);

 private:
  std::vector<std::vector<std::uint8_t>> chunks_;
  std::int64_t map_version_ = -1;
  std::size_t missing_ = 0;
};

}  // namespace citrine
