#include "sim/lidar/observability.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

namespace citrine::sim {
namespace {

constexpr int kBatch = 8;
constexpr int kBatchesBeforeLookingBehind = 4;
constexpr double kProbe_m = 0.02;

/// The level field of view by sines, so that no angle is computed.
struct FieldOfView {
  explicit FieldOfView(const LidarModel& model)
      : sin_min(static_cast<float>(std::sin(model.elevation_min_rad) - 1e-6)),
        sin_max(static_cast<float>(std::sin(model.elevation_max_rad) + 1e-6)) {}
  bool Contains(float z_S, float range_m) const {
    return z_S >= sin_min * range_m && z_S <= sin_max * range_m;
  }
  float sin_min, sin_max;
};

struct Offset {
  Eigen::Vector3i steps;
  float length_m;
};

/// Steps from the lattice point nearest to a sample to the poses that may see it, shortest first.
std::vector<Offset> OffsetsInRange(const LidarModel& model, const FieldOfView& view) {
  const auto rounding_m = static_cast<float>(kLatticeStep_m * std::sqrt(3.0) / 2);
  const auto reach_m = static_cast<float>(model.range_max_m) + rounding_m;
  const int reach = static_cast<int>(std::ceil(reach_m / kLatticeStep_m));
  std::vector<Offset> offsets;
  for (int z = -reach; z <= reach; ++z)
    for (int y = -reach; y <= reach; ++y)
      for (int x = -reach; x <= reach; ++x) {
        const Eigen::Vector3i steps(x, y, z);
        const auto length_m = static_cast<float>(kLatticeStep_m * steps.cast<double>().norm());
        const auto down_m = static_cast<float>(-kLatticeStep_m * z);  // the sample's height above the pose
        const float range_m = length_m + rounding_m;
        if (length_m > reach_m || length_m < model.range_min_m - rounding_m) continue;
        if (down_m + rounding_m < view.sin_min * range_m || down_m - rounding_m > view.sin_max * range_m)
          continue;
        offsets.push_back({steps, length_m});
      }
  std::ranges::stable_sort(offsets, {}, &Offset::length_m);
  return offsets;
}

/// Looks for poses that see one sample after the other.
class Viewer {
 public:
  Viewer(const ReachableLattice& lattice, const RayScene& scene, const LidarModel& model)
      : lattice_(lattice),
        scene_(scene),
        model_(model),
        view_(model),
        offsets_(OffsetsInRange(model, view_)) {}

  struct Seen {
    bool observable = false, within_goal = false;
  };

  Seen Look(const SurfaceSample& sample, double d_star_m) {
    begin_ = {&sample, static_cast<float>(std::min(d_star_m, model_.range_max_m)), {}, 0, false};
    const Eigen::Vector3i base = lattice_.Nearest(sample.p_W.cast<double>());
    const auto rounding_m = static_cast<float>(kLatticeStep_m * std::sqrt(3.0) / 2);
    if (last_) Offer(*last_);
    for (const Offset& offset : offsets_) {
      if (begin_.seen.within_goal) break;
      if (begin_.seen.observable && offset.length_m > begin_.goal_m + rounding_m) break;
      const Eigen::Vector3i i = base + offset.steps;
      if (lattice_.Contains(i) && lattice_.reachable[lattice_.Linear(i)]) Offer(i);
    }
    Fire();
    return begin_.seen;
  }

 private:
  struct State {
    const SurfaceSample* sample = nullptr;
    float goal_m = 0;
    Seen seen;
    int batches = 0;
    bool solid_behind = false;
  };

  /// Takes a pose into the next batch of rays if the sample is in its range and field of view.
  void Offer(const Eigen::Vector3i& i) {
    const Eigen::Vector3f from_W = lattice_.Position(i).cast<float>();
    const Eigen::Vector3f ray = begin_.sample->p_W - from_W;
    const float range_m = ray.norm();
    if (range_m < model_.range_min_m || range_m > model_.range_max_m || !view_.Contains(ray.z(), range_m))
      return;
    if (begin_.solid_behind && ray.dot(begin_.sample->n_W) >= 0) return;
    poses_[pending_] = i;
    from_W_[pending_] = from_W;
    range_m_[pending_] = range_m;
    if (++pending_ == kBatch) Fire();
  }

  void Fire() {
    if (pending_ == 0) return;
    std::array<Eigen::Vector3f, kBatch> target_W;
    target_W.fill(begin_.sample->p_W);
    std::array<std::uint8_t, kBatch> free;
    scene_.Unoccluded({from_W_.data(), static_cast<std::size_t>(pending_)},
                      {target_W.data(), static_cast<std::size_t>(pending_)},
                      {free.data(), static_cast<std::size_t>(pending_)});
    for (int k = 0; k < pending_ && !begin_.seen.within_goal; ++k) {
      if (!free[k]) continue;
      begin_.seen.observable = true;
      begin_.seen.within_goal = range_m_[k] <= begin_.goal_m;
      last_ = poses_[k];
    }
    pending_ = 0;
    // A sample that is hard to see: poses behind its own solid are not worth a ray.
    if (++begin_.batches == kBatchesBeforeLookingBehind)
      begin_.solid_behind = scene_.Solid(
          (begin_.sample->p_W - static_cast<float>(kProbe_m) * begin_.sample->n_W).cast<double>());
  }

  const ReachableLattice& lattice_;
  const RayScene& scene_;
  const LidarModel& model_;
  FieldOfView view_;
  std::vector<Offset> offsets_;
  std::optional<Eigen::Vector3i> last_;  ///< pose that saw the sample before; neighbours see alike
  State begin_;
  int pending_ = 0;
  std::array<Eigen::Vector3i, kBatch> poses_;
  std::array<Eigen::Vector3f, kBatch> from_W_;
  std::array<float, kBatch> range_m_;
};

}  // namespace

Observability FindObservable(const std::vector<SurfaceSample>& samples, const ReachableLattice& lattice,
                             const RayScene& scene, const LidarModel& model, const QualityGoals& goals) {
  Observability flags{std::vector<std::uint8_t>(samples.size(), 0),
                      std::vector<std::uint8_t>(samples.size(), 0)};
  if (lattice.num_reachable() == 0) return flags;
  Viewer viewer(lattice, scene, model);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Viewer::Seen seen = viewer.Look(samples[i], goals.At(samples[i].p_W.cast<double>()).d_star_m);
    flags.observable[i] = seen.observable;
    flags.within_goal[i] = seen.within_goal;
  }
  return flags;
}

}  // namespace citrine::sim
