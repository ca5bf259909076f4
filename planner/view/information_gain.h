#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/map/planning_map.h"
#include "planner/view/clear_cells.h"
#include "planner/view/elements.h"
#include "planner/view/sensor_window.h"

namespace citrine::planner {

/// h of eq. (9): 1 within eta of d*, 0.5 nearer, falling from 0.5 to 0 at r_max farther; 0 beyond r_max.
/// At d* - eta and d* + eta exactly, which the paper leaves open, the outer case holds.
double DistanceWorth(double distance_m, double d_star_m, double eta_m, double range_max_m);

/// The sum of eq. (8) over all elements, before it is normalised, and |ASE_v|.
struct Gain {
  double sum = 0;   ///< sum of h vis over ASE_v
  int visible = 0;  ///< |ASE_v|: elements in range and field of view that nothing occupied hides
};

/// The most that a view's gain can be.
struct GainBound {
  double sum = 0;
  int visible = 0;
  int hidden = 0;  ///< elements in range and field of view that are hidden for certain
};

/// Evaluates eq. (8) for views, and bounds it from above without looking for what hides elements.
class InformationGain {
 public:
  InformationGain(const PlanningMap& map, const std::vector<Element>& elements, const SensorWindow& window,
                  double eta_m);

  Gain Evaluate(const Eigen::Vector3d& view_W) const;

  /// From which of 24 sectors of directions an element was last found hidden, one bit each: where to look
  /// first for what rules a view out. Changes no result.
  using Hunch = std::vector<std::uint32_t>;
  Hunch NoHunch() const { return Hunch(elements_.size(), 0); }

  /// |ASE_v| of a view; -1, sooner, if it is less than `visible_min`.
  /// @param bound  what Bound() said of the view
  int CountVisible(const Eigen::Vector3d& view_W, const GainBound& bound, int visible_min,
                   Hunch& hunch) const;

  /// At least what Evaluate gives, in both numbers. Leaves out elements that turn their back to the view and
  /// whose neighbour on the first step towards it is occupied: those are hidden for certain.
  GainBound Bound(const Eigen::Vector3d& view_W) const;

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
  std::vector<int>
      backed_;  ///< bit a: the face neighbour in direction a of -x, +x, -y, +y, -z, +z is occupied
  std::vector<float> near2_, far2_;  ///< squared ends of the interval of viewing distances [m^2]
  double far_worth_ = 0;             ///< the most that h is beyond it
  std::vector<Bucket> buckets_;
  ClearCells clear_, without_occupied_;
};

}  // namespace citrine::planner
