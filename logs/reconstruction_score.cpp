#include "logs/reconstruction_score.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <nanoflann.hpp>

#include "logs/percentile.h"
#include "logs/surface_samples.h"

namespace citrine::logs {
namespace {

using Points = std::vector<Eigen::Vector3f>;

struct Cloud {
  const Points& points;
  std::size_t kdtree_get_point_count() const { return points.size(); }
  float kdtree_get_pt(std::size_t i, std::size_t axis) const { return points[i][static_cast<int>(axis)]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};
using Tree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Cloud>, Cloud, 3, std::uint32_t>;

/// [m] from each of `queries` to the nearest of `points`; both not empty.
std::vector<float> NearestDistances(const Points& queries, const Points& points) {
  const Cloud cloud{points};
  const Tree tree(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(12));
  std::vector<float> distances_m(queries.size());
  for (std::size_t i = 0; i < queries.size(); ++i) {
    std::uint32_t index = 0;
    float squared = 0;
    tree.knnSearch(queries[i].data(), 1, &index, &squared);
    distances_m[i] = std::sqrt(squared);
  }
  return distances_m;
}

double Percent(std::size_t part, std::size_t whole) {
  return whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

void ScoreCompleteness(const ScoreTruth& truth, const Points& mesh_W, ReconstructionScore& score) {
  std::vector<std::uint8_t> covered(truth.samples_W.size(), 0);
  if (!mesh_W.empty()) {
    const std::vector<float> distances_m = NearestDistances(truth.samples_W, mesh_W);
    for (std::size_t i = 0; i < covered.size(); ++i) covered[i] = distances_m[i] < score.options.threshold_m;
  }
  score.coverage_pct =
      Percent(std::accumulate(covered.begin(), covered.end(), std::size_t{0}), covered.size());

  std::size_t observable = 0, observable_covered = 0;
  for (std::size_t i = 0; i < truth.observable.size(); ++i) {
    observable += truth.observable[i] != 0;
    observable_covered += truth.observable[i] != 0 && covered[i] != 0;
  }
  if (observable > 0) score.observable_coverage_pct = Percent(observable_covered, observable);
}

void ScoreAccuracy(const ScoreTruth& truth, const Points& mesh_W, ReconstructionScore& score) {
  score.mesh_samples = mesh_W.size();
  if (mesh_W.empty()) return;
  std::vector<float> errors_m;
  for (const Eigen::Vector3f& p_W : mesh_W)
    errors_m.push_back(static_cast<float>(truth.distance(p_W.cast<double>())));
  const auto precise = std::count_if(errors_m.begin(), errors_m.end(),
                                     [&](float error_m) { return error_m < score.options.threshold_m; });
  score.precision_pct = Percent(static_cast<std::size_t>(precise), errors_m.size());
  score.surface_error_mean_m =
      std::accumulate(errors_m.begin(), errors_m.end(), 0.0) / static_cast<double>(errors_m.size());
  score.surface_error_p95_m = Percentile(std::move(errors_m), 95);
}

}  // namespace

std::optional<ReconstructionScore> ScoreReconstruction(const TriMesh& reconstruction, const ScoreTruth& truth,
                                                       const ScoreOptions& options) {
  if (truth.samples_W.empty()) return std::nullopt;
  ReconstructionScore score;
  score.options = options;
  score.true_samples = truth.samples_W.size();
  ScoreCompleteness(truth, SampleSurface(reconstruction, options.neighbours_per_m2, options.seed), score);
  ScoreAccuracy(truth, SampleSurface(reconstruction, options.samples_per_m2, options.seed + 1), score);
  const double sum = score.coverage_pct + score.precision_pct;
  score.f_score_pct = sum > 0 ? 2 * score.coverage_pct * score.precision_pct / sum : 0;
  return score;
}

}  // namespace citrine::logs
