#include "modules/map_fusion/map_fusion_module.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iterator>
#include <tuple>
#include <utility>

#include "core/map/mission_grid.h"
#include "core/map/ply.h"
#include "core/parallel_for.h"
#include "core/quality/map_quality.h"
#include "fusion/cloud_image.h"
#include "fusion/surface_mesh.h"
#include "fusion/teammate_filter.h"
#include "modules/codec/bad_message.h"
#include "modules/codec/fleet_status.h"
#include "modules/codec/lidar_scan.h"
#include "modules/codec/map_blocks.h"
#include "modules/codec/map_summary.h"
#include "modules/codec/mission_progress.h"
#include "modules/codec/octree.h"
#include "modules/codec/saved_map.h"
#include "modules/codec/uav_state.h"
#include "modules/hear_nouns.h"
#include "modules/runtime/cpu_stopwatch.h"

namespace citrine {
namespace {

constexpr double kProgress_hz = 2;
constexpr const char* kSavedMap = "/map.tsdf";
constexpr int kBlockMessagesAStep =
    2;  // pace: of at most 33 kB each, so that default receive buffers hold them

fusion::WeightPolicy PolicyOf(const MapSection& map) {
  if (const auto policy = fusion::WeightPolicyOf(map.weight_policy)) return *policy;
  throw ConfigError("map.weight_policy = \"" + map.weight_policy +
                    "\": best_view, per_scan or per_point is allowed");
}

template <class Message>
void Queue(std::vector<Message> messages, std::deque<Message>& queue) {
  std::move(messages.begin(), messages.end(), std::back_inserter(queue));
}

}  // namespace

MapFusionModule::MapFusionModule(const ModuleContext& context)
    : config_(context.config),
      bus_(context.bus),
      health_(context.health),
      hearer_(context.map_hearer),
      fuser_(MissionGrid(config_), config_.map.truncation_m, MissionQuantisation(config_),
             PolicyOf(config_.map), config_.quality_goals()),
      rotation_(fuser_.map().grid().num_blocks(),
                static_cast<int>(std::floor(config_.map.rotation_s * config_.map.publish_hz))),
      no_view_left_(static_cast<std::size_t>(config_.mission.uavs), false),
      states_(bus_.HearAll(channels::kUavState)),
      scans_(bus_.HearAll(channels::kLidarScan)),
      clouds_(bus_.HearAll(channels::kPointCloud)),
      fleet_statuses_(bus_.HearAll(channels::kFleetStatus)),
      publish_(1 / config_.map.publish_hz),
      progress_(1 / kProgress_hz) {
  GoOnFromSavedMap();
  if (config_.map.octree_hz > 0) say_octree_.emplace(1 / config_.map.octree_hz);
}

void MapFusionModule::Tick(const Step& step) {
  HearFleet();
  IntegrateScans();
  hearer_->Update(step);
  const bool blocks = blocks_to_say_.empty() && publish_.Due(step.now), progress = progress_.Due(step.now);
  const std::vector<MapBlock> next = blocks ? NextBlocks() : std::vector<MapBlock>{};
  // What is fused and what is heard of it are two maps.
  if (blocks || progress)
    RunParts(3, [&](int part) {
      if (part == 0 && blocks) Queue(EncodeInMessages(next), blocks_to_say_);
      if (part == 1 && blocks) summary_to_say_ = Encode(fuser_.Summary());
      if (part == 2 && progress) progress_to_say_ = Progress();
    });
  if (octree_to_say_.empty() && say_octree_ && say_octree_->Due(step.now)) QueueOctree();
  SayQueued();
  if (step.last) WriteResults();
}

/// What it wrote itself, when it was stopped in the middle of this mission, comes first.
void MapFusionModule::GoOnFromSavedMap() {
  const std::string own = config_.launch.out.empty() ? "" : config_.launch.out + kSavedMap;
  const std::string& path = !own.empty() && std::filesystem::exists(own) ? own : config_.map.start;
  if (path.empty()) return;
  SavedMap saved = ReadSavedMap(path, config_);
  fuser_.Restore(std::move(saved.map), saved.integrations);
  std::fprintf(stderr, "%s: goes on from %s\n", kName, path.c_str());
}

void MapFusionModule::HearFleet() {
  HearNouns(bus_, channels::kUavState, kEveryUav, *states_,
            [this](int uav, const UavState& state, Utime) { positions_.Hear(uav, state); });
  HearNouns(bus_, channels::kFleetStatus, config_.mission.uavs, *fleet_statuses_,
            [this](int uav, const FleetStatus& status, Utime) {
              no_view_left_[static_cast<std::size_t>(uav) - 1] = status.no_view_left;
            });
}

std::vector<std::pair<int, LidarScan>> MapFusionModule::TakeScans() {
  std::vector<std::pair<int, LidarScan>> scans;
  HearNouns(bus_, channels::kLidarScan, kEveryUav, *scans_,
            [&](int uav, LidarScan scan, Utime) { scans.emplace_back(uav, std::move(scan)); });
  for (const auto& [uav, message] : clouds_->Take()) {
    try {
      if (const std::optional<PointCloud> cloud = chunks_.Hear(uav, message))
        scans.emplace_back(uav, fusion::Binned(*cloud, config_.lidar.model));
    } catch (const BadMessage& error) {
      bus_.Reject(channels::kPointCloud.Of(uav), error.what());
    }
  }
  std::stable_sort(scans.begin(), scans.end(), [](const auto& a, const auto& b) {
    return std::tie(a.second.measured, a.first) < std::tie(b.second.measured, b.first);
  });
  return scans;
}

void MapFusionModule::IntegrateScans() {
  for (auto& [uav, scan] : TakeScans()) {
    const CpuStopwatch stopwatch(CpuStopwatch::Of::kProcess);
    fusion::DropTeammates(scan, positions_.Others(uav, scan.measured));
    fuser_.Integrate(scan);
    health_.Sample("integration_ms", stopwatch.ms());
  }
}

std::vector<MapBlock> MapFusionModule::NextBlocks() {
  std::vector<MapBlock> blocks;
  const std::vector<int> changed = fuser_.TakeChanged(), next = rotation_.Next(changed);
  for (std::size_t i = 0; i < next.size(); ++i) {
    if (i >= changed.size()) fuser_.Renew(next[i]);
    blocks.push_back(*fuser_.Said(next[i]));
  }
  return blocks;
}

void MapFusionModule::QueueOctree() {
  octree_.Update(hearer_->map());
  const OctreeBytes octree{std::max<std::int64_t>(hearer_->map_version(), 0), config_.map.voxel_m,
                           octree_.Bytes()};
  Queue(EncodeInMessages(octree), octree_to_say_);
}

void MapFusionModule::SayQueued() {
  for (int i = 0; i < kBlockMessagesAStep && !blocks_to_say_.empty(); ++i) {
    bus_.Publish(channels::kMapBlocks, std::move(blocks_to_say_.front()));
    blocks_to_say_.pop_front();
  }
  if (blocks_to_say_.empty() && summary_to_say_) {
    bus_.Publish(channels::kMapSummary, *summary_to_say_);
    summary_to_say_.reset();
  }
  if (!octree_to_say_.empty()) {
    bus_.Publish(channels::kMapOctree, std::move(octree_to_say_.front()));
    octree_to_say_.pop_front();
  }
  if (progress_to_say_) bus_.Publish(channels::kMissionProgress, Encode(*progress_to_say_));
  progress_to_say_.reset();
}

bool MapFusionModule::NobodyHasAViewLeft() const {
  return std::all_of(no_view_left_.begin(), no_view_left_.end(), [](bool none) { return none; });
}

MissionProgress MapFusionModule::Progress() {
  const std::int64_t version = std::max<std::int64_t>(hearer_->map_version(), 0);
  return ProgressOf(hearer_->map(), hearer_->Surface(), NobodyHasAViewLeft(), version);
}

void MapFusionModule::WriteResults() {
  if (config_.launch.out.empty()) return;
  try {
    RunParts(2, [&](int part) {
      if (part == 0) {
        const CpuStopwatch stopwatch;
        WritePly(config_.launch.out + "/mesh.ply", fusion::SurfaceMesh(fuser_.map()));
        health_.Sample("mesh_ms", stopwatch.ms());
      } else {
        WriteSavedMap(config_.launch.out + kSavedMap, fuser_.map(), fuser_.integrations(), config_);
      }
    });
    // What was fused since the last publication belongs to the octree, too.
    PlanningMap whole = hearer_->map();
    fuser_.TakeChanged();
    for (int block = 0; block < whole.grid().num_blocks(); ++block) {
      if (!fuser_.Said(block)) continue;
      fuser_.Renew(block);
      whole.Apply(*fuser_.Said(block));
    }
    whole.Update();
    octree_.Update(whole);
    octree_.WriteBt(config_.launch.out + "/map.bt");
  } catch (const std::exception& error) {
    health_.Error(error.what());
  }
}

}  // namespace citrine
