#include "modules/map_fusion/cloud_chunks.h"

#include <algorithm>
#include <utility>

#include "modules/codec/bad_message.h"
#include "modules/codec/point_cloud.h"

namespace citrine {
namespace {

constexpr int kMostChunks = 4096;

}  // namespace

std::optional<PointCloud> CloudChunks::Hear(int uav, const citrine_lcm::point_cloud_t& message) {
  PointCloud chunk = Decode(message);
  Require(message.num_chunks <= kMostChunks, "point_cloud_t: too many chunks");
  std::optional<PointCloud> done;
  Sweep& sweep = sweeps_[uav];
  if (sweep.num_chunks > 0 && sweep.cloud.measured != chunk.measured) {
    Require(chunk.measured > sweep.cloud.measured, "point_cloud_t: a chunk of a sweep that is over");
    if (!sweep.heard.empty()) done = std::move(sweep.cloud);
    sweep = {};
  }
  if (sweep.num_chunks == 0) {
    sweep.num_chunks = message.num_chunks;
    sweep.heard.assign(static_cast<std::size_t>(message.num_chunks), false);
    sweep.cloud = chunk;
    sweep.cloud.points_S.clear();
  }
  Require(message.num_chunks == sweep.num_chunks, "point_cloud_t: num_chunks differs within a sweep");
  if (sweep.heard.empty() || sweep.heard[message.chunk]) return done;
  sweep.heard[message.chunk] = true;
  sweep.cloud.points_S.insert(sweep.cloud.points_S.end(), chunk.points_S.begin(), chunk.points_S.end());
  if (!done && std::all_of(sweep.heard.begin(), sweep.heard.end(), [](bool heard) { return heard; })) {
    done = sweep.cloud;
    sweep.heard.clear();  // said; what comes of it again is passed over
    sweep.cloud.points_S.clear();
  }
  return done;
}

}  // namespace citrine
