#include "modules/codec/map_blocks.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "core/parallel_for.h"
#include "modules/codec/bad_message.h"
#include "modules/codec/packed_bytes.h"

namespace citrine {
namespace {

constexpr std::size_t kBlockBytes = 2 * kBlockVoxels;

}  // namespace

citrine_lcm::map_blocks_t Encode(const std::vector<MapBlock>& blocks) {
  if (blocks.size() > kMaxBlocksAMessage) throw std::invalid_argument("too many blocks for one message");
  citrine_lcm::map_blocks_t message{};
  message.num_blocks = static_cast<std::int32_t>(blocks.size());
  std::vector<std::uint8_t> codes;
  codes.reserve(kBlockBytes * blocks.size());
  for (const MapBlock& block : blocks) {
    message.index.push_back(block.index);
    message.version.push_back(block.version);
    codes.insert(codes.end(), block.distance.begin(), block.distance.end());
    codes.insert(codes.end(), block.weight.begin(), block.weight.end());
  }
  message.codes = Pack(codes);
  message.num_bytes = static_cast<std::int32_t>(message.codes.size());
  return message;
}

std::vector<citrine_lcm::map_blocks_t> EncodeInMessages(const std::vector<MapBlock>& blocks) {
  const std::size_t count = (blocks.size() + kMaxBlocksAMessage - 1) / kMaxBlocksAMessage;
  std::vector<citrine_lcm::map_blocks_t> messages(count);
  RunParts(static_cast<int>(count), [&](int part) {
    const auto first = blocks.begin() + part * static_cast<std::ptrdiff_t>(kMaxBlocksAMessage);
    const auto last = first + std::min<std::ptrdiff_t>(kMaxBlocksAMessage, blocks.end() - first);
    messages[static_cast<std::size_t>(part)] = Encode({first, last});
  });
  return messages;
}

std::vector<MapBlock> Decode(const citrine_lcm::map_blocks_t& message) {
  Require(message.num_blocks <= kMaxBlocksAMessage, "map_blocks_t: too many blocks");
  const std::size_t size = kBlockBytes * static_cast<std::size_t>(message.num_blocks);
  const auto codes = Unpack(message.codes, size, "map_blocks_t: codes do not fit num_blocks");
  std::vector<MapBlock> blocks(message.index.size());
  auto next = codes.begin();
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    Require(message.index[i] >= 0, "map_blocks_t: index < 0");
    Require(message.version[i] > 0 && message.version[i] <= std::numeric_limits<std::uint32_t>::max(),
            "map_blocks_t: version out of range");
    blocks[i].index = message.index[i];
    blocks[i].version = static_cast<std::uint32_t>(message.version[i]);
    std::copy_n(next, kBlockVoxels, blocks[i].distance.begin());
    std::copy_n(next + kBlockVoxels, kBlockVoxels, blocks[i].weight.begin());
    next += kBlockBytes;
  }
  return blocks;
}

}  // namespace citrine
