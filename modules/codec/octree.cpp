#include "modules/codec/octree.h"

#include <algorithm>
#include <iterator>

#include "modules/codec/bad_message.h"

namespace citrine {
namespace {

constexpr std::size_t kChunkBytes = 32 * 1024;
constexpr int kMostChunks = 1 << 14;

}  // namespace

std::vector<citrine_lcm::octree_t> EncodeInMessages(const OctreeBytes& octree) {
  const std::size_t count = std::max<std::size_t>(1, (octree.bytes.size() + kChunkBytes - 1) / kChunkBytes);
  std::vector<citrine_lcm::octree_t> messages;
  for (std::size_t i = 0; i < count; ++i) {
    citrine_lcm::octree_t message{};
    message.map_version = octree.map_version;
    message.resolution_m = octree.resolution_m;
    message.chunk = static_cast<std::int32_t>(i);
    message.num_chunks = static_cast<std::int32_t>(count);
    const std::size_t last = std::min(octree.bytes.size(), (i + 1) * kChunkBytes);
    message.data.assign(octree.bytes.begin() + static_cast<std::ptrdiff_t>(i * kChunkBytes),
                        octree.bytes.begin() + static_cast<std::ptrdiff_t>(last));
    message.num_bytes = static_cast<std::int32_t>(message.data.size());
    messages.push_back(std::move(message));
  }
  return messages;
}

std::optional<OctreeBytes> OctreeAssembler::Add(const citrine_lcm::octree_t& message) {
  Require(message.num_chunks > 0 && message.num_chunks <= kMostChunks && message.chunk >= 0 &&
              message.chunk < message.num_chunks,
          "octree_t: chunk outside num_chunks");
  RequireFinite("octree_t: resolution_m is not a number", message.resolution_m);
  Require(message.resolution_m > 0, "octree_t: resolution_m <= 0");
  const bool last_only = message.chunk + 1 == message.num_chunks;
  Require(last_only || message.data.size() == kChunkBytes, "octree_t: a chunk cut short");
  if (message.map_version != map_version_ || chunks_.size() != static_cast<std::size_t>(message.num_chunks)) {
    map_version_ = message.map_version;
    chunks_.assign(static_cast<std::size_t>(message.num_chunks), {});
    missing_ = chunks_.size();
  }
  auto& chunk = chunks_[static_cast<std::size_t>(message.chunk)];
  if (!chunk.empty() || message.data.empty()) return std::nullopt;
  chunk = message.data;
  if (--missing_ > 0) return std::nullopt;
  OctreeBytes octree{message.map_version, message.resolution_m, {}};
  for (const auto& part : chunks_) octree.bytes.insert(octree.bytes.end(), part.begin(), part.end());
  return octree;
}

}  // namespace citrine
