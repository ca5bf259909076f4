#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/map/planning_map.h"
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
  InformationGain(const PlanningMap& map, const std::vector<Element>& elements, const SensorWindow& window,
                  double eta_m);

  Gain Evaluate(const Eigen::Vector3d& view_W) const;

  /// An element in range and field of view.
  struct InWindow {
    int element;           ///< counted by this class
    std::uint32_t sector;  ///< the one of 24 sectors of directions that it lies in, one bit
    bool averted;          ///< turns its back to the view
    double worth;          ///< h of eq. (9)
  };
  /// Appends those of a view, in a fixed order, but those that are hidden for certain.
  void AppendInWindow(const Eigen::Vector3d& view_W, std::vector<InWindow>& elements) const;
  /// delta and u of eq. (7) for eight of them.
  std::array<Sight, 8> Look(const std::array<int, 8>& elements, const Eigen::Vector3d& view_W) const;
  std::size_t num_elements() const { return elements_.size(); }

  /// At least what Evaluate gives for any view in a box, in both numbers. Looks only at the neighbour of each
  /// element on the first step towards the views: one that is occupied hides an element that turns its back,
  /// one that is unknown counts in u.
  Gain Bound(const Eigen::AlignedBox3d& views_W) const;
  Gain Bound(const Eigen::Vector3d& view_W) const { return Bound(Eigen::AlignedBox3d(view_W)); }

 private:
  struct Bucket {
    Eigen::Vector3f min_W, max_W;
    int begin, end;
  };
  struct Eight;
  struct Box;
  Eight SeenFrom(const Box& views, int first) const;
  template <class Visit>
  void ForEachNear(const Eigen::AlignedBox3f& views_W, Visit&& visit) const;
  /// @param visit  void(int first, const Eight&): the elements of near buckets, eight by eight
  template <class Visit>
  void ForEachEight(const Eigen::AlignedBox3d& views_W, Visit&& visit) const;

  const PlanningMap& map_;
  SensorWindow window_;
  double eta_m_;
  std::vector<Element> elements_;  ///< by bucket, then by voxel
  // Their rows: exact, and as floats to bound with.
  std::array<std::vector<double>, 3> p_W_;
  std::vector<double> d_star_m_;
  std::array<std::vector<float>, 3> position_, normal_;
  std::vector<float> near_m_, far_m_;  ///< ends of the interval of viewing distances
  std::vector<int> backed_, clouded_;  ///< faces with something occupied, unknown behind them; one bit each
  std::vector<Bucket> buckets_;
};

}  // namespace citrine::planner
