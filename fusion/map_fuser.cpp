#include "fusion/map_fuser.h"

#include <algorithm>
#include <utility>

#include "core/digest.h"

namespace citrine::fusion {

MapFuser::MapFuser(const VoxelGrid& grid, double truncation_m, const Quantisation& quantisation,
                   WeightPolicy policy)
    : map_(grid, truncation_m),
      quantisation_(quantisation),
      integrator_(map_, policy),
      touched_(grid.num_blocks(), 0),
      said_(grid.num_blocks()) {}

void MapFuser::Integrate(const LidarScan& scan) {
  const std::vector<int> changed = integrator_.Integrate(scan);
  for (int block : changed) touched_[block] = 1;
  integrations_ += !changed.empty();
}

void MapFuser::Restore(TsdfMap saved, std::int64_t integrations) {
  map_ = std::move(saved);
  integrations_ = std::max<std::int64_t>(integrations, 1);
  for (int block = 0; block < map_.grid().num_blocks(); ++block)
    touched_[block] = map_.Find(block) != nullptr;
}

std::vector<int> MapFuser::TakeChanged() {
  std::vector<int> changed;
  for (int block = 0; block < map_.grid().num_blocks(); ++block) {
    if (!std::exchange(touched_[block], std::uint8_t{0})) continue;
    MapBlock now = map_.Quantise(block, quantisation_);
    std::unique_ptr<MapBlock>& said = said_[block];
    if (said && said->distance == now.distance && said->weight == now.weight) continue;
    map_.MarkChanged(block);
    now.version = map_.version(block);
    num_blocks_said_ += !said;
    said = std::make_unique<MapBlock>(now);
    changed.push_back(block);
  }
  if (!changed.empty()) version_said_ = integrations_;
  return changed;
}

MapSummary MapFuser::Summary() const {
  Digest digest;
  for (const auto& block : said_) {
    if (!block) continue;
    const std::int32_t index = block->index;
    digest.Add(&index, sizeof index);
    digest.Add(block->distance.data(), block->distance.size());
    digest.Add(block->weight.data(), block->weight.size());
  }
  return {map_.grid(),   map_.truncation_m(), quantisation_.weight_max(),
          version_said_, num_blocks_said_,    digest.value()};
}

}  // namespace citrine::fusion
