#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/map/planning_map.h"
#include "planner/view/elements.h"
#include "planner/view/sensor_window.h"
#include "planner/view/view.h"

namespace citrine::planner {

/// Makes view candidates (paper, IV-A), and beyond the paper finds views of elements that its samples cannot
/// see.
///
/// Samples along the normal, first safe one from which the element is not hidden: optimal at d* - eta/2,
/// close at 0.6 (d* - eta), far at d* + 2 eta (at most r_max). A normal outside the field of view is turned
/// towards the horizon to the limit minus 1 degree; a vertical one takes its azimuth from the UAV. An element
/// that an earlier view failed to settle tries the close sample first, where beams are denser, and 10 degrees
/// inside the field of view.
///
/// A view is only made from where the element can be improved: an LQSE from nearer than its weight says that
/// it has been seen (the weight of one look at d is 1/d^2), unless weights are sums.
class ViewGenerator {
 public:
  struct Options {
    double eta_m = 0.5;
    bool weights_are_sums = false;  ///< any further look improves a weight
  };
  /// Whether a UAV may be there and can get there: inside the volume, clear, connected. Several threads ask
  /// it.
  using Safe = std::function<bool(const Eigen::Vector3d& p_W)>;

  ViewGenerator(const PlanningMap& map, const SensorWindow& window, Safe safe, const Options& options);

  /// The paper's view of an element. nullopt: no sample is safe and sees it
  std::optional<View> AlongNormal(const Element& element, const Eigen::Vector3d& uav_W) const;

  /// Fallback of this project: a fixed fan of 64 directions within 80 degrees of the normal, nearest to it
  /// first, at the same distances; the first safe one with a clear sight through known space.
  std::optional<View> Around(const Element& element) const;

  /// The last resort, and the test for what remains out of reach (ISE_rem of eq. 1; design, section 6): of
  /// all poses of a 0.5 m lattice that are safe and see the element, the one with the fewest unknown voxels
  /// in between, then the distance nearest to the optimal one.
  std::optional<View> Search(const Element& element) const {
    LatticeAnswers answers;
    return Search(element, answers);
  }
  /// Which poses of the lattice are safe, as far as they were asked for; true while neither the map nor what
  /// is connected changes.
  class LatticeAnswers {
    friend class ViewGenerator;
    enum class Answer : std::uint8_t { kNotAsked, kSafe, kUnsafe };
    std::vector<Answer> of_pose_;
  };
  /// As above; asks only for what is not answered yet.
  std::optional<View> Search(const Element& element, LatticeAnswers& answers) const;

  /// Whether a view still is safe and sees its element with use.
  bool Holds(const View& view, const Element& element) const;

  /// [m] the farthest from which a look improves the element.
  double UsefulRange(const Element& element) const;

 private:
  std::array<std::pair<double, View::Kind>, 3> Distances(const Element& element) const;
  /// A pose of the lattice that has an element in range and field of view.
  struct LatticePose {
    Eigen::Matrix<std::int16_t, 3, 1> off;  ///< from the element [voxels]
    int cells;                              ///< on, among the lattice's cells, from the element's
    double distance_m;
  };
  /// All of them around an element, in order of z, y, x. Made when first asked for, once for each way in
  /// which a voxel can lie to the lattice.
  const std::vector<LatticePose>& LatticeAround(const VoxelIndex& voxel) const;
  /// Of a cell of the lattice among all of them.
  int CellNumber(const Eigen::Vector3i& cell) const {
    return (cell.z() * cells_.y() + cell.y()) * cells_.x() + cell.x();
  }
  Eigen::Vector3d Turned(const Eigen::Vector3d& normal_W, const Eigen::Vector3d& to_uav_W,
                         double margin_rad) const;

  const PlanningMap& map_;
  SensorWindow window_;
  Safe safe_;
  Options options_;
  int stride_;             ///< of the lattice [voxels]
  Eigen::Vector3i cells_;  ///< of the lattice, as many as it has poses
  mutable std::vector<std::vector<LatticePose>> lattice_;
  double lowest_rad_, highest_rad_;  ///< elevation of a view seen from its element
  std::array<Eigen::Vector3d, 64> fan_;
};

/// Cells of 3x3x3 voxels in which elements with normals within 20 degrees share a view (design, section 6).
class SharedViews {
 public:
  explicit SharedViews(const VoxelGrid& grid);
  /// The element that already has a view which this one can share; -1: none.
  int Leader(const std::vector<Element>& elements, int i) const;
  /// Notes that element i has a view of its own.
  void Lead(const std::vector<Element>& elements, int i);

 private:
  std::size_t CellOf(const Element& element) const;
  Eigen::Vector3i cells_;
  VoxelIndex first_;
  std::vector<int> newest_;                 ///< by cell: the last leader, -1 none
  std::vector<std::pair<int, int>> chain_;  ///< leader, index of the one before it in its cell
};

}  // namespace citrine::planner
