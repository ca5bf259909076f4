#include "planner/view/view_generator.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "core/parallel_for.h"
#include "core/quality/confidence.h"
#include "planner/view/visibility.h"

namespace citrine::planner {

namespace {

constexpr double kDegree = EIGEN_PI / 180;
constexpr double kMargin = kDegree;                 ///< of a view to the limit of the field of view
constexpr double kSafeMargin = 10 * kDegree;        ///< after a view that failed: a UAV is not always level
constexpr double kVertical = 0.1;                   ///< sine of the tilt below which a normal has no azimuth
constexpr double kFanCosine = 0.17364817766693041;  ///< of 80 degrees
constexpr double kLattice_m = 0.5;
constexpr int kParts = 2;  ///< of a search of the lattice, for as many threads
constexpr double kImprovement =
    0.97;  ///< of the range already seen from: 6 % more weight, beyond the code's 2 %

View Make(const Eigen::Vector3d& p_W, const Element& element, View::Kind kind) {
  const Eigen::Vector3d to = element.p_W - p_W;
  return {p_W, std::atan2(to.y(), to.x()), element.linear, element.p_W, kind};
}

Eigen::Vector3d Direction(double azimuth_rad, double elevation_rad) {
  return {std::cos(elevation_rad) * std::cos(azimuth_rad), std::cos(elevation_rad) * std::sin(azimuth_rad),
          std::sin(elevation_rad)};
}

/// Of the poses tried that see an element: the first of those with the fewest unknown voxels in between, then
/// the least off the best distance. Looks from eight at once.
class BestPose {
 public:
  /// @param clear_off_m  the least off of all poses of all parts of a search that see past nothing unknown
  BestPose(const PlanningMap& map, const Element& element, std::atomic<double>& clear_off_m)
      : map_(map), clear_off_m_(clear_off_m) {
    elements_.fill(&element);
  }

  /// Whether a pose that far off cannot be better than what has been found, here or elsewhere.
  bool NoneBetterAt(double off_m) const {
    return (unknown_ == 0 && off_m >= off_m_) || off_m > clear_off_m_.load(std::memory_order_relaxed);
  }
  void Try(const Eigen::Vector3d& p_W, double off_m) {
    tried_[static_cast<std::size_t>(count_++)] = {p_W, off_m};
    if (count_ == 8) Look();
  }
  void End() { Look(); }
  const std::optional<Eigen::Vector3d>& found_W() const { return found_W_; }
  bool BetterThan(const BestPose& earlier) const {
    return found_W_ && std::pair(unknown_, off_m_) < std::pair(earlier.unknown_, earlier.off_m_);
  }

 private:
  struct Tried {
    Eigen::Vector3d p_W;
    double off_m;
  };
  void Look() {
    if (count_ == 0) return;
    std::array<const Eigen::Vector3d*, 8> views_W;
    for (int k = 0; k < 8; ++k)
      views_W[static_cast<std::size_t>(k)] = &tried_[static_cast<std::size_t>(std::min(k, count_ - 1))].p_W;
    const std::array<Sight, 8> sights = LookAtEight(map_, elements_, views_W);
    for (std::size_t k = 0; k < static_cast<std::size_t>(count_); ++k) {
      if (!sights[k].clear || std::pair(sights[k].unknown, tried_[k].off_m) >= std::pair(unknown_, off_m_))
        continue;
      found_W_ = tried_[k].p_W;
      unknown_ = sights[k].unknown;
      off_m_ = tried_[k].off_m;
    }
    count_ = 0;
    double least_m = clear_off_m_;
    while (unknown_ == 0 && off_m_ < least_m && !clear_off_m_.compare_exchange_weak(least_m, off_m_))
      continue;
  }

  const PlanningMap& map_;
  std::atomic<double>& clear_off_m_;
  std::array<const Element*, 8> elements_;
  std::array<Tried, 8> tried_;
  int count_ = 0;
  std::optional<Eigen::Vector3d> found_W_;
  int unknown_ = 1 << 20;
  double off_m_ = 0;
};

}  // namespace

ViewGenerator::ViewGenerator(const PlanningMap& map, const SensorWindow& window, Safe safe,
                             const Options& options)
    : map_(map),
      window_(window),
      safe_(std::move(safe)),
      options_(options),
      stride_(std::max(1, static_cast<int>(std::lround(kLattice_m / map.grid().voxel_m())))),
      cells_(map.grid().voxels().array() / stride_ + 1),
      lattice_(static_cast<std::size_t>(stride_ * stride_ * stride_)),
      lowest_rad_(-window.elevation_max_rad()),
      highest_rad_(-window.elevation_min_rad()) {
  const double low = lowest_rad_ + kDegree, high = highest_rad_ - kDegree;
  for (int i = 0; i < 64; ++i) fan_[i] = Direction(i % 16 * EIGEN_PI / 8, low + (high - low) * (i / 16) / 3);
}

double ViewGenerator::UsefulRange(const Element& element) const {
  if (element.kind == SurfaceClass::kIse || options_.weights_are_sums || element.weight <= 0)
    return window_.range_max_m();
  return std::min(window_.range_max_m(),
                  std::max(kImprovement / std::sqrt(element.weight), element.d_star_m));
}

std::array<std::pair<double, View::Kind>, 3> ViewGenerator::Distances(const Element& element) const {
  const double d_star = element.d_star_m, eta = options_.eta_m;
  std::array<std::pair<double, View::Kind>, 3> distances{
      {{std::min(d_star - eta / 2, window_.range_max_m()), View::Kind::kOptimal},
       {0.6 * (d_star - eta), View::Kind::kClose},
       {std::min(d_star + 2 * eta, window_.range_max_m()), View::Kind::kFar}}};
  if (element.attempts > 0) std::swap(distances[0], distances[1]);
  return distances;
}

Eigen::Vector3d ViewGenerator::Turned(const Eigen::Vector3d& normal_W, const Eigen::Vector3d& to_uav_W,
                                      double margin_rad) const {
  const bool vertical = std::hypot(normal_W.x(), normal_W.y()) < kVertical;
  const Eigen::Vector3d& azimuth_of = vertical ? to_uav_W : normal_W;
  const double elevation = std::asin(std::clamp(normal_W.z(), -1.0, 1.0));
  if (!vertical && elevation >= lowest_rad_ && elevation <= highest_rad_) return normal_W;
  return Direction(std::atan2(azimuth_of.y(), azimuth_of.x()),
                   std::clamp(elevation, lowest_rad_ + margin_rad, highest_rad_ - margin_rad));
}

std::optional<View> ViewGenerator::AlongNormal(const Element& element, const Eigen::Vector3d& uav_W) const {
  if (element.normal_W.isZero()) return std::nullopt;
  const Eigen::Vector3d along =
      Turned(element.normal_W, uav_W - element.p_W, element.attempts > 0 ? kSafeMargin : kMargin);
  const double useful = UsefulRange(element);
  for (const auto& [distance, kind] : Distances(element)) {
    if (distance > useful || distance < window_.range_min_m()) continue;
    const Eigen::Vector3d p_W = element.p_W + distance * along;
    if (safe_(p_W) && LookAt(map_, element, p_W).clear) return Make(p_W, element, kind);
  }
  return std::nullopt;
}

std::optional<View> ViewGenerator::Around(const Element& element) const {
  std::array<std::pair<double, int>, 64> order;
  int count = 0;
  for (int i = 0; i < 64; ++i) {
    const double cosine = element.normal_W.isZero() ? 1 : element.normal_W.dot(fan_[i]);
    if (cosine > kFanCosine) order[count++] = {-cosine, i};
  }
  std::sort(order.begin(), order.begin() + count);
  const double useful = UsefulRange(element);
  for (int k = 0; k < count; ++k)
    for (const auto& [distance, kind] : Distances(element)) {
      if (distance > useful || distance < window_.range_min_m()) continue;
      const Eigen::Vector3d p_W = element.p_W + distance * fan_[order[k].second];
      if (!safe_(p_W)) continue;
      const Sight sight = LookAt(map_, element, p_W, 0);
      if (sight.clear) return Make(p_W, element, View::Kind::kAround);
    }
  return std::nullopt;
}

const std::vector<ViewGenerator::LatticePose>& ViewGenerator::LatticeAround(const VoxelIndex& voxel) const {
  const Eigen::Array3i phase = voxel.array() - voxel.array() / stride_ * stride_;
  std::vector<LatticePose>& poses = lattice_[phase.x() + stride_ * (phase.y() + stride_ * phase.z())];
  if (!poses.empty()) return poses;
  const double voxel_m = map_.grid().voxel_m();
  const int reach = (static_cast<int>(window_.range_max_m() / voxel_m) / stride_ + 1) * stride_;
  Eigen::Vector3i off;  // of the pose from the element
  for (off.z() = -reach - phase.z(); off.z() <= reach; off.z() += stride_)
    for (off.y() = -reach - phase.y(); off.y() <= reach; off.y() += stride_)
      for (off.x() = -reach - phase.x(); off.x() <= reach; off.x() += stride_) {
        if (off.squaredNorm() > reach * reach) continue;
        const Eigen::Vector3d to = (-off).cast<double>() * voxel_m;
        if (window_.Sees(to))
          poses.push_back(
              {off.cast<std::int16_t>(), CellNumber((off + phase.matrix()) / stride_), to.norm()});
      }
  return poses;
}

std::optional<View> ViewGenerator::Search(const Element& element, LatticeAnswers& answers) const {
  using Answer = LatticeAnswers::Answer;
  const VoxelGrid& grid = map_.grid();
  answers.of_pose_.resize(static_cast<std::size_t>(cells_.prod()), Answer::kNotAsked);
  const int own_cell = CellNumber(element.voxel / stride_);
  const double useful = UsefulRange(element);
  const double best_distance = Distances(element)[0].first;
  const std::vector<LatticePose>& poses = LatticeAround(element.voxel);
  std::atomic<double> clear_off_m = std::numeric_limits<double>::infinity();
  std::array<BestPose, kParts> best{BestPose(map_, element, clear_off_m),
                                    BestPose(map_, element, clear_off_m)};
  RunParts(kParts, [&](int part) {
    BestPose& here = best[static_cast<std::size_t>(part)];
    const std::size_t end = poses.size() * static_cast<std::size_t>(part + 1) / kParts;
    for (std::size_t k = poses.size() * static_cast<std::size_t>(part) / kParts; k < end; ++k) {
      const LatticePose& pose = poses[k];
      const VoxelIndex v = element.voxel + pose.off.cast<int>();
      if (pose.distance_m > useful || !grid.Inside(v)) continue;
      const double off_m = std::abs(pose.distance_m - best_distance);
      if (here.NoneBetterAt(off_m)) continue;
      Answer& answer = answers.of_pose_[static_cast<std::size_t>(own_cell + pose.cells)];
      if (answer == Answer::kUnsafe) continue;
      const Eigen::Vector3d p_W = grid.Centre(v);
      if (answer == Answer::kNotAsked) answer = safe_(p_W) ? Answer::kSafe : Answer::kUnsafe;
      if (answer == Answer::kSafe) here.Try(p_W, off_m);
    }
    here.End();
  });
  const BestPose& found = best[best[1].BetterThan(best[0]) ? 1 : 0];
  return found.found_W() ? std::optional<View>(Make(*found.found_W(), element, View::Kind::kAround))
                         : std::nullopt;
}

bool ViewGenerator::Holds(const View& view, const Element& element) const {
  const Eigen::Vector3d to = element.p_W - view.p_W;
  return to.norm() <= UsefulRange(element) && window_.Sees(to) && safe_(view.p_W) &&
         LookAt(map_, element, view.p_W).clear;
}

SharedViews::SharedViews(const VoxelGrid& grid)
    : cells_((grid.voxels().array() + 2) / 3 + 1),
      first_(grid.inside_min()),
      newest_(static_cast<std::size_t>(cells_.prod()), -1) {}

std::size_t SharedViews::CellOf(const Element& element) const {
  const Eigen::Vector3i c = (element.voxel - first_) / 3;
  return static_cast<std::size_t>(c.x()) +
         static_cast<std::size_t>(cells_.x()) * (c.y() + static_cast<std::size_t>(cells_.y()) * c.z());
}

int SharedViews::Leader(const std::vector<Element>& elements, int i) const {
  static const double kAlike = std::cos(20 * kDegree);
  const Element& e = elements[i];
  for (int at = newest_[CellOf(e)]; at >= 0; at = chain_[at].second) {
    const Element& leader = elements[chain_[at].first];
    if (leader.d_star_m == e.d_star_m && leader.attempts == e.attempts &&
        leader.normal_W.dot(e.normal_W) >= kAlike)
      return chain_[at].first;
  }
  return -1;
}

void SharedViews::Lead(const std::vector<Element>& elements, int i) {
  int& newest = newest_[CellOf(elements[i])];
  chain_.emplace_back(i, newest);
  newest = static_cast<int>(chain_.size()) - 1;
}

}  // namespace citrine::planner
