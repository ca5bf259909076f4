#pragma once

#include "core/map/tsdf_map.h"
#include "fusion/voxel_observer.h"
#include "fusion/weight_policy.h"

namespace citrine::fusion {

/// Averages what a scan says about the voxels of a brick into what was known of them (Curless & Levoy 1996).
///
/// A surface once seen is kept from free rays, the more the better it was seen; where none was, that it is
/// free is all that free rays tell. What has been seen often enough is moved by nearer looks alone, so that
/// hovering does not wear it away.
class BrickFuser {
 public:
  BrickFuser(double truncation_m, WeightPolicy policy)
      : truncation_m_(static_cast<float>(truncation_m)), policy_(policy) {}

  /// @return whether anything changed that could be said
  bool Fuse(const Observation& observation, int brick, TsdfBlock& block) const;
  /// The same for a brick never observed, all of which is seen free.
  void FuseFree(int brick, TsdfBlock& block) const;

 private:
  float truncation_m_;
  WeightPolicy policy_;
};

}  // namespace citrine::fusion
