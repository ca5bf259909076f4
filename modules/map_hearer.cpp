#include "modules/map_hearer.h"

#include <optional>
#include <vector>

#include "core/map/mission_grid.h"
#include "modules/channels.h"
#include "modules/codec/map_blocks.h"
#include "modules/codec/map_summary.h"
#include "modules/hear_nouns.h"

namespace citrine {

struct MapHearer::Impl {
  Impl(const MissionConfig& config, Bus& the_bus)
      : bus(the_bus),
        map(MissionPlanningMap(config)),
        goals(config.quality_goals()),
        reachable(
            std::make_shared<planner::ReachableSet>(map, config.uav.limits, config.planner.path_margin_m)),
        topological_grid(map),
        blocks(bus.Hear(channels::kMapBlocks)),
        summaries(bus.Hear(channels::kMapSummary)) {}

  void HearBlocks();
  std::optional<MapSummary> NewestSummary();
  /// Brings the elements up to date if anybody has asked for them.
  void FollowSurface();
  void Compare(const MapSummary& summary);

  Bus& bus;
  PlanningMap map;
  QualityGoals goals;
  std::optional<ActiveSurface> surface;
  std::int64_t surface_revision = -1;
  std::shared_ptr<planner::ReachableSet> reachable;
  planner::TopologicalGrid topological_grid;
  std::shared_ptr<Inbox<citrine_lcm::map_blocks_t>> blocks;
  std::shared_ptr<Inbox<citrine_lcm::map_summary_t>> summaries;
  std::int64_t last_step = -1;
  bool changed_in_step = false;
  std::int64_t version = -1;
  std::uint64_t digest = 0;  ///< of the map at `digest_revision`
  std::int64_t digest_revision = -1;
};

MapHearer::MapHearer(const MissionConfig& config, Bus& bus) : impl_(std::make_unique<Impl>(config, bus)) {}
MapHearer::~MapHearer() = default;

bool MapHearer::Update(const Step& step) {
  if (step.index != impl_->last_step) {
    impl_->last_step = step.index;
    impl_->HearBlocks();
    const std::optional<MapSummary> summary = impl_->NewestSummary();
    impl_->changed_in_step = impl_->map.Update({[this] { impl_->FollowSurface(); },
                                                [&] {
                                                  if (summary) impl_->Compare(*summary);
                                                }});
    if (summary && !impl_->changed_in_step) impl_->Compare(*summary);
  }
  return impl_->changed_in_step;
}

void MapHearer::Impl::HearBlocks() {
  HearNouns(bus, channels::kMapBlocks, *blocks, [this](const std::vector<MapBlock>& heard, Utime) {
    for (const MapBlock& block : heard)
      Require(block.index < map.grid().num_blocks(), "map_blocks_t: a block outside the mission's grid");
    for (const MapBlock& block : heard) map.Apply(block);
  });
}

std::optional<MapSummary> MapHearer::Impl::NewestSummary() {
  std::optional<MapSummary> newest;
  HearNouns(bus, channels::kMapSummary, *summaries, [&](const MapSummary& summary, Utime) {
    Require(summary.grid == map.grid(), "map_summary_t: another grid than the mission's");
    Require(summary.truncation_m == map.quantisation().truncation_m() &&
                summary.weight_max == map.quantisation().weight_max(),
            "map_summary_t: other codes than the mission's");
    newest = summary;
  });
  return newest;
}

void MapHearer::Impl::FollowSurface() {
  if (!surface || surface_revision == map.revision()) return;
  surface->Update(map);
  surface_revision = map.revision();
}

void MapHearer::Impl::Compare(const MapSummary& summary) {
  if (summary.num_blocks != map.num_blocks_known()) return;
  if (digest_revision != map.revision()) {
    digest = map.Digest();
    digest_revision = map.revision();
  }
  if (digest == summary.digest) version = summary.map_version;
}

const PlanningMap& MapHearer::map() const { return impl_->map; }

const ActiveSurface& MapHearer::Surface() {
  std::optional<ActiveSurface>& surface = impl_->surface;
  if (!surface) surface.emplace(map().grid(), map().quantisation(), impl_->goals);
  impl_->FollowSurface();
  return *surface;
}

std::shared_ptr<planner::ReachableSet> MapHearer::reachable() { return impl_->reachable; }
planner::TopologicalGrid& MapHearer::topological_grid() { return impl_->topological_grid; }

std::int64_t MapHearer::map_version() const { return impl_->version; }

}  // namespace citrine
