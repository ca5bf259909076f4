#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/map/tri_mesh.h"

namespace citrine::logs {

/// What a reconstruction is held against.
struct ScoreTruth {
  std::vector<Eigen::Vector3f>
      samples_W;  ///< [m] uniform by area on the true surface inside the mission volume
  std::vector<std::uint8_t> observable;  ///< one a sample, nonzero where it can be seen at all; or empty
  /// [m] from a point to the true surface, exact. It is not cut at the border of the volume, for the map
  /// reaches beyond.
  std::function<double(const Eigen::Vector3d& p_W)> distance;
};

struct ScoreOptions {
  double threshold_m = 0;
  double neighbours_per_m2 =
      400;  ///< points on the reconstruction among which a true sample looks for its nearest
  double samples_per_m2 = 100;  ///< points on the reconstruction whose distance to the truth is taken
  std::uint64_t seed = 1;
};

/// Completeness and accuracy of a reconstruction, after Knapitsch et al. (2017), on points drawn uniformly by
/// area.
struct ReconstructionScore {
  ScoreOptions options;
  std::size_t true_samples = 0, mesh_samples = 0;
  double coverage_pct =
      0;  ///< recall: true samples with a point of the reconstruction nearer than the threshold
  double precision_pct = 0;  ///< points of the reconstruction nearer to the true surface than the threshold
  double f_score_pct = 0;    ///< harmonic mean of both
  std::optional<double> observable_coverage_pct;  ///< recall of the observable samples
  /// [m] from points of the reconstruction to the true surface; nothing for an empty reconstruction
  std::optional<double> surface_error_mean_m, surface_error_p95_m;
};

/// @return nothing if there is no true sample
std::optional<ReconstructionScore> ScoreReconstruction(const TriMesh& reconstruction, const ScoreTruth& truth,
                                                       const ScoreOptions& options);

}  // namespace citrine::logs
