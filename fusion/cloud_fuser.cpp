#include "fusion/cloud_fuser.h"

#include "core/grid/grid_around.h"
#include "fusion/cloud_image.h"

namespace citrine::fusion {

CloudFuser::CloudFuser(const Options& options)
    : options_(options),
      map_(GridAround(options.voxel_m, {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()}),
           options.truncation_m),
      integrator_(map_, WeightPolicy::kBestView, options.threads) {}

std::size_t CloudFuser::Integrate(const std::vector<Eigen::Vector3f>& points_S, const Pose& X_WS) {
  PointCloud cloud{.measured = 0,
                   .X_WS = X_WS,
                   .range_min_m = options_.range_min_m,
                   .range_max_m = options_.range_max_m,
                   .points_S = {}};
  Eigen::AlignedBox3d told_W(X_WS.p);
  for (const Eigen::Vector3f& p_S : points_S) {
    const float range_m = p_S.norm();
    if (!(range_m >= options_.range_min_m && range_m <= options_.range_max_m)) continue;
    cloud.points_S.push_back(p_S);
    told_W.extend(X_WS * p_S.cast<double>());
  }
  if (cloud.points_S.empty()) return 0;
  if (!model_) model_ = GuessModel(cloud.points_S, options_.range_min_m, options_.range_max_m);
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(options_.truncation_m + 2 * options_.voxel_m);
  map_.GrowTo({told_W.min() - margin, told_W.max() + margin});
  integrator_.Integrate(Binned(cloud, *model_));
  return cloud.points_S.size();
}

}  // namespace citrine::fusion
