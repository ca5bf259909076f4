#pragma once

#include <optional>
#include <string>

namespace citrine::fusion {

/// What counts as the confidence of a surface voxel (design, section 6). Distances are always averaged by the
/// sum.
enum class WeightPolicy {
  kBestView,  ///< the best single observation: w >= w* exactly when seen from within d*
  kPerScan,   ///< summed, once a voxel and scan
  kPerPoint,  ///< summed over the returns that fall into the voxel
};

inline std::optional<WeightPolicy> WeightPolicyOf(const std::string& name) {
  if (name == "best_view") return WeightPolicy::kBestView;
  if (name == "per_scan") return WeightPolicy::kPerScan;
  if (name == "per_point") return WeightPolicy::kPerPoint;
  return std::nullopt;
}

}  // namespace citrine::fusion
