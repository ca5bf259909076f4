#include "fusion/map_fuser.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "core/digest.h"
#include "core/map/planning_map.h"
#include "core/parallel_for.h"
#include "core/quality/confidence.h"

namespace citrine::fusion {

namespace {
constexpr int kParts = 8;  ///< of blocks, that threads take
}  // namespace

MapFuser::MapFuser(const VoxelGrid& grid, double truncation_m, const Quantisation& quantisation,
                   WeightPolicy policy, const QualityGoals& goals)
    : map_(grid, truncation_m),
      quantisation_(quantisation),
      integrator_(map_, policy, kParts),
      touched_(grid.num_blocks(), 0),
      said_(grid.num_blocks()) {
  const auto reaches = [&](int code, const QualityGoal& goal) {
    return quantisation.Weight(static_cast<std::uint8_t>(code)) >= kReached * goal.w_star;
  };
  for (int code = 0; code < 256; ++code) {
    const double distance_m = quantisation.Distance(static_cast<std::uint8_t>(code));
    class_of_[code] =
        code == kUnknownCode
            ? 0
            : static_cast<std::uint8_t>(1 + (distance_m > -grid.voxel_m()) +
                                        (distance_m >= PlanningMap::kSiteBelow_vox * grid.voxel_m()) +
                                        (distance_m > grid.voxel_m()) + (code == kFreeCode));
    goals_of_[code] = reaches(code, goals.whole());
    for (const QualityGoals::Region& region : goals.regions()) goals_of_[code] += reaches(code, region.goal);
  }
}

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
  std::vector<int> touched, changed;
  for (int block = 0; block < map_.grid().num_blocks(); ++block)
    if (std::exchange(touched_[block], std::uint8_t{0})) touched.push_back(block);
  std::vector<MapBlock> now(touched.size());
  std::vector<std::uint8_t> matters(touched.size());
  ParallelForEach(touched.size(), kParts, [&](std::size_t i) {
    now[i] = map_.Quantise(touched[i], quantisation_);
    const MapBlock* said = Said(touched[i]);
    matters[i] = !said || Matters(*said, now[i]);
  });
  for (std::size_t i = 0; i < touched.size(); ++i) {
    if (!matters[i]) continue;
    Say(now[i]);
    changed.push_back(touched[i]);
  }
  return changed;
}

void MapFuser::Renew(int block) {
  const MapBlock now = map_.Quantise(block, quantisation_);
  if (said_[block]->distance != now.distance || said_[block]->weight != now.weight) Say(now);
}

bool MapFuser::Matters(const MapBlock& said, const MapBlock& now) const {
  for (int i = 0; i < kBlockVoxels; ++i)
    if (class_of_[said.distance[i]] != class_of_[now.distance[i]] ||
        goals_of_[said.weight[i]] != goals_of_[now.weight[i]] ||
        std::abs(said.distance[i] - now.distance[i]) > kStillDistance ||
        std::abs(said.weight[i] - now.weight[i]) > kStillWeight)
      return true;
  return false;
}

void MapFuser::Say(const MapBlock& now) {
  std::unique_ptr<MapBlock>& said = said_[now.index];
  num_blocks_said_ += !said;
  map_.MarkChanged(now.index);
  said = std::make_unique<MapBlock>(now);
  said->version = map_.version(now.index);
  version_said_ = integrations_;
}

MapSummary MapFuser::Summary() const {
  Digest digest;
  for (const auto& block : said_) {
    if (block) digest.Add(block->content().data(), block->content().size());
  }
  return {map_.grid(),   map_.truncation_m(), quantisation_.weight_max(),
          version_said_, num_blocks_said_,    digest.value()};
}

}  // namespace citrine::fusion
