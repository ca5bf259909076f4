#pragma once

#include <string>

#include <Eigen/Geometry>

namespace citrine::viz {

/// Which part of a mission a picture shows, and what of it.
struct View {
  Eigen::AlignedBox2d area_W;  ///< [m] of the map part
  double pixels_per_m = 24;
  std::string hidden;  ///< keys of the layers that are not drawn
  bool help = false;   ///< names the keys
};

}  // namespace citrine::viz
