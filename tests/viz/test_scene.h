#pragma once

#include <functional>
#include <memory>

#include "viz/scene.h"

namespace citrine::viz {

/// [m] signed distance to a surface, positive outside.
using Shape = std::function<double(const Eigen::Vector3d&)>;
/// [m] distance from which a place was seen best; beyond 10 m it was not.
using SeenFrom = std::function<double(const Eigen::Vector3d&)>;

/// A map of a shape as it would be after flying by.
std::unique_ptr<PlanningMap> MapOf(const Eigen::AlignedBox3d& volume_W, const Shape& shape,
                                   const SeenFrom& seen_from);

/// A mission over a small settlement (a house with a gable roof, two cars, a playground) that three UAVs have
/// half done.
struct TestScene {
  Eigen::AlignedBox3d volume_W{Eigen::Vector3d(-22.5, -20, 0), Eigen::Vector3d(22.5, 20, 20)};
  std::unique_ptr<PlanningMap> map;
  Scene scene;

  TestScene();
};

}  // namespace citrine::viz
