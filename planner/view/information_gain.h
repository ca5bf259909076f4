#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/map/planning_map.h"
#include "planner/view/clear_cells.h"
#include "planner/view/elements.h"
#include "planner/view/sensor_window.h"
#include "planner/view/visibility.h"

namespace citrine::planner {

/// h of eq. (9): 1 within eta of d*, 0.5 nearer, falling from 0.5 to 0 at r_max farther; 0 beyond r_max.
/// At d* - eta and d* + eta exactly, which the paper leaves open, the outer case holds.
double DistanceWorth(double distance_m, double d_star_m, double eta_m, double range_max_m);

/// The sum of eq. (8) over all elements, before it is normalised, and |ASE_v|.
struct Gain {
  double sum = 0;   ///< sum of h vis over ASE_v
  int visible = 0;  ///< |ASE_v|: elements in range and field of view that nothing occupied hides
};

/// Evaluates eq. (8) for views, and bounds it from above without looking for what hides elements.
class InformationGain {
 public:
  /// @param views about how many will be asked for: for many it prepares what makes each of them faster
  InformationGain(const PlanningMap& map, const std::vector<Element>& elements, const SensorWindow& window,
                  double eta_m, std::size_t views = 1000);

  Gain Evaluate(const Eigen::Vector3d& view_W) const;

  /// An element in range and field of view.
  struct InWindow {
    int element;           ///< counted by this class
    std::uint32_t sector;  ///< the one of 24 sectors of directions that it lies in, one bit
    bool averted;          ///< turns its back to the view
    double worth;          ///< h of eq. (9)
  };
  /// Appends those of a view, in a fixed order.
  void AppendInWindow(const Eigen::Vector3d& view_W, std::vector<InWindow>& elements) const;
  /// delta and u of eq. (7) for one of them.
  Sight Look(const InWindow& element, const Eigen::Vector3d& view_W) const {
    return LookAt(map_, elements_[element.element], view_W, clear_ ? &*clear_ : nullptr);
  }
  std::size_t num_elements() const { return elements_.size(); }

  /// At least what Evaluate gives, in both numbers. Looks only at the neighbour of each element on the first
  /// step towards the view: one that is occupied hides an element that turns its back, one that is unknown
  /// counts in u.
  Gain Bound(const Eigen::Vector3d& view_W) const;

 private:
  struct Bucket {
    Eigen::Vector3f min_W, max_W;
    int begin, end;
  };
  struct Eight;
  template <class Visit>
  void ForEachNear(const Eigen::Vector3d& view_W, Visit&& visit) const;
  /// @param visit  void(int first, const Eight&): the elements of near buckets, eight by eight
  template <class Visit>
  void ForEachEight(const Eigen::Vector3d& view_W, Visit&& visit) const;

  const PlanningMap& map_;
  SensorWindow window_;
  double eta_m_;
  std::vector<Element> elements_;  ///< by bucket, then by voxel
  std::vector<float> x_, y_, z_;
  std::vector<float> normal_x_, normal_y_, normal_z_;
  std::vector<int> backed_,
      clouded_;  ///< faces behind which lies an occupied, an unknown voxel; one bit each
  std::vector<float> near_m_, far_m_;  ///< ends of the interval of viewing distances
  std::vector<Bucket> buckets_;
  std::optional<ClearCells> clear_;  ///< where many views are asked for
};

}  // namespace citrine::planner
