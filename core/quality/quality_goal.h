#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace citrine {

/// How well a surface is to be seen: from within d*, that is with confidence w* = 1/d*^2 (eq. 5).
struct QualityGoal {
  double d_star_m = 4.5;
  double w_star = 1.0 / (4.5 * 4.5);

  /// Eq. (5) backwards: the goal whose reference distance is d*.
  static QualityGoal FromDistance(double d_star_m) { return {d_star_m, 1.0 / (d_star_m * d_star_m)}; }
};

/// The goals of a mission: one for the whole volume, and one for each region of its own (section IV-D).
class QualityGoals {
 public:
  struct Region {
    Eigen::AlignedBox3d box_W;
    QualityGoal goal;
  };

  QualityGoals() = default;
  explicit QualityGoals(QualityGoal whole, std::vector<Region> regions = {})
      : whole_(whole), regions_(std::move(regions)) {}

  /// The part of the volume that a point lies in: 0 for what is in no region, else one more than the index of
  /// the region; where regions overlap the first one listed holds.
  std::size_t PartOf(const Eigen::Vector3d& p_W) const {
    for (std::size_t i = 0; i < regions_.size(); ++i)
      if (regions_[i].box_W.contains(p_W)) return i + 1;
    return 0;
  }
  const QualityGoal& OfPart(std::size_t part) const { return part == 0 ? whole_ : regions_[part - 1].goal; }
  const QualityGoal& At(const Eigen::Vector3d& p_W) const { return OfPart(PartOf(p_W)); }
  const std::vector<Region>& regions() const { return regions_; }
  const QualityGoal& whole() const { return whole_; }
  double w_star_max() const {
    double w = whole_.w_star;
    for (const Region& region : regions_) w = std::max(w, region.goal.w_star);
    return w;
  }
  double d_star_max() const {
    double d = whole_.d_star_m;
    for (const Region& region : regions_) d = std::max(d, region.goal.d_star_m);
    return d;
  }

 private:
  QualityGoal whole_;
  std::vector<Region> regions_;
};

}  // namespace citrine
