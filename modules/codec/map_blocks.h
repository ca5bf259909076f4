#pragma once

#include <vector>

#include <citrine_lcm/map_blocks_t.hpp>

#include "core/map/map_block.h"

namespace citrine {

/// So many blocks stay under 33 kB however badly they pack.
inline constexpr int kMaxBlocksAMessage = 31;

/// @throws std::invalid_argument for more than kMaxBlocksAMessage
citrine_lcm::map_blocks_t Encode(const std::vector<MapBlock>& blocks);
/// As many messages as it takes, in the order given.
std::vector<citrine_lcm::map_blocks_t> EncodeInMessages(const std::vector<MapBlock>& blocks);

/// @throws BadMessage for an index or version that cannot be, or codes that do not fit the count. Whether the
/// index lies
///         in the grid is for the hearer to check, who knows the grid.
std::vector<MapBlock> Decode(const citrine_lcm::map_blocks_t& message);

}  // namespace citrine
