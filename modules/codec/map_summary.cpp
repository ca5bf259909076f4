#include "modules/codec/map_summary.h"

#include "modules/codec/bad_message.h"
#include "modules/codec/geometry.h"

namespace citrine {
namespace {

constexpr double kMostVoxels = 1e9;  // of a grid: what is larger is a mistake, not a mission

}  // namespace

citrine_lcm::map_summary_t Encode(const MapSummary& summary) {
  citrine_lcm::map_summary_t message{};
  message.map_version = summary.map_version;
  message.digest = static_cast<std::int64_t>(summary.digest);
  message.num_blocks = summary.num_blocks;
  message.margin_voxels = summary.grid.inside_min().x();
  message.voxel_m = summary.grid.voxel_m();
  message.truncation_m = summary.truncation_m;
  message.weight_max = summary.weight_max;
  EncodeVector(summary.grid.volume_W().min(), message.volume_min_W);
  EncodeVector(summary.grid.volume_W().max(), message.volume_max_W);
  return message;
}

MapSummary Decode(const citrine_lcm::map_summary_t& message) {
  RequireFinite("map_summary_t: a length or weight is not a number", message.voxel_m, message.truncation_m,
                message.weight_max);
  Require(message.voxel_m > 0 && message.truncation_m > 0 && message.weight_max > 0,
          "map_summary_t: a length or weight <= 0");
  Require(message.margin_voxels >= 0 && message.margin_voxels < 1000,
          "map_summary_t: margin_voxels out of range");
  const Eigen::AlignedBox3d volume_W(
      DecodeVector(message.volume_min_W, "map_summary_t: volume_min_W is not finite"),
      DecodeVector(message.volume_max_W, "map_summary_t: volume_max_W is not finite"));
  Require(!volume_W.isEmpty(), "map_summary_t: the volume is empty");
  const Eigen::Array3d voxels =
      volume_W.sizes().array() / message.voxel_m + 2.0 * message.margin_voxels + kBlockSide;
  Require(voxels.prod() < kMostVoxels, "map_summary_t: the grid is too large");
  MapSummary summary;
  summary.grid = VoxelGrid(message.voxel_m, volume_W, message.margin_voxels * message.voxel_m);
  summary.truncation_m = message.truncation_m;
  summary.weight_max = message.weight_max;
  summary.map_version = message.map_version;
  summary.num_blocks = message.num_blocks;
  summary.digest = static_cast<std::uint64_t>(message.digest);
  Require(
      summary.map_version >= 0 && summary.num_blocks >= 0 && summary.num_blocks <= summary.grid.num_blocks(),
      "map_summary_t: map_version or num_blocks out of range");
  return summary;
}

}  // namespace citrine
