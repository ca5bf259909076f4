#include "fusion/brick_fuser.h"

#include "fusion/lanes.h"

namespace citrine::fusion {
namespace {

// Share of its weight that a free observation has where a surface was seen before.
constexpr float kFreeOnSurface = 0.2f;

// [1/m^2] Weight of a voxel only ever seen free, a hundredth of that of a surface 10 m away: the first that
// see one there say where it is.
constexpr float kFreeWeight = 1e-4f;

// A look adds nothing where what is known outweighs it as many times: by then noise is averaged away, and
// what is left of a look's error is the same each time.
constexpr float kLooks = 16;

}  // namespace

bool BrickFuser::Fuse(const Observation& observation, int brick, TsdfBlock& block) const {
  const int at = brick * kBrickVoxels;
  const Lanes distance = Load(&block.distance_m[at]), weight = Load(&block.weight[at]),
              quality = Load(&block.quality[at]);
  const Lanes codes_per_m = 127.0f / truncation_m_;

  // A free ray seldom knows better than whoever saw a surface here from nearer by, and nothing new where all
  // is free.
  const Mask is_free = observation.sdf_m >= truncation_m_, was_known = weight > 0.0f;
  const Mask nothing_new = is_free & was_known & (distance >= truncation_m_);
  const Mask free_on_surface = Without((quality > 0.0f) & is_free, observation.in_band);
  const Lanes ratio = Min(observation.looked / Max(quality, 1e-9f), 1.0f);
  const Lanes share = Select(free_on_surface, ratio * ratio * kFreeOnSurface, 1.0f) * observation.share;
  const Mask said = Without(observation.said, nothing_new);
  const Lanes offered = Select(Without(is_free, was_known), kFreeWeight, observation.weight * share);
  const Lanes added =
      Select(said, Min(offered, Max(MulAdd(offered, kLooks, Lanes(0.0f) - weight), 0.0f)), 0.0f);
  const Lanes sum = weight + added;
  const Lanes mean = Select(was_known, MulAdd(distance, weight, observation.sdf_m * added) / Max(sum, 1e-30f),
                            observation.sdf_m);
  const Lanes fused = Select(said, Min(Max(mean, -truncation_m_), truncation_m_), distance);

  Lanes confidence = quality;
  if (policy_ == WeightPolicy::kBestView)
    confidence =
        Select(observation.in_band, Max(quality, observation.weight),
               Select(observation.said & free_on_surface, Max(quality, observation.looked), quality));
  else if (policy_ == WeightPolicy::kPerScan)
    confidence = Select(observation.in_band, quality + observation.weight, quality);
  Store(&block.distance_m[at], fused);
  Store(&block.weight[at], sum);
  Store(&block.quality[at], confidence);
  const Mask clear = Without((fused >= truncation_m_) & (sum > 0.0f), confidence > 0.0f);
  const std::uint64_t bit = std::uint64_t{1} << brick;
  block.clear_bricks = clear.all() ? block.clear_bricks | bit : block.clear_bricks & ~bit;

  const Mask first_seen = Without(sum > 0.0f, was_known);
  const Mask moved = Round(fused * codes_per_m) != Round(distance * codes_per_m);
  return (first_seen | moved | (confidence != quality)).any();
}

void BrickFuser::FuseFree(int brick, TsdfBlock& block) const {
  Store(&block.distance_m[brick * kBrickVoxels], truncation_m_);
  Store(&block.weight[brick * kBrickVoxels], kFreeWeight);
  block.clear_bricks |= std::uint64_t{1} << brick;
}

}  // namespace citrine::fusion
