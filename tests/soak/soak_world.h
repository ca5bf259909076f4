#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "sim/world/world.h"

namespace citrine::soak {

/// A place to fly in, and who flies where: one start and one goal a UAV.
struct Scenario {
  std::string kind;
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();  ///< of the mission volume, from the origin
  sim::World world;
  std::vector<Eigen::Vector3d> spawns_W, goals_W;
  std::uint64_t seed = 1;
};

/// One UAV from corner to corner of a random forest that lets it through.
Scenario Forest(std::uint64_t seed);

/// Two or three UAVs that want the same space at the same time: on a line towards each other, across each
/// other's way, or through a gap of 3 m in a wall from both sides. Offsets and directions are the seed's.
Scenario HeadOn(std::uint64_t seed, int uavs);
Scenario Crossing(std::uint64_t seed, int uavs);
Scenario NarrowGap(std::uint64_t seed, int uavs);

}  // namespace citrine::soak
