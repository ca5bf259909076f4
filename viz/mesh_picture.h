#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "core/map/tri_mesh.h"

namespace citrine::viz {

/// Where a mesh is looked at from: an orthographic view of the box, from `azimuth_rad` and `elevation_rad`.
struct MeshView {
  Eigen::AlignedBox3d box_W;          ///< [m] what is to fill the picture
  double azimuth_rad = -2.1;          ///< of the viewer, seen from the box's centre
  double elevation_rad = 0.6;
  cv::Size size{1600, 1000};
  double ceiling_m = 1e9;             ///< triangles wholly above are left out
  float weight_goal = 0;              ///< w*: vertices of full confidence are warm, poor ones cold; 0: plain grey
};

/// A shaded picture (BGR) of a mesh, z-buffered, two-sided; faces turned away from the viewer are drawn darker and bluish,
/// so that holes and inside-out surfaces are seen at a glance.
cv::Mat DrawMesh(const TriMesh& mesh, const MeshView& view);

}  // namespace citrine::viz
