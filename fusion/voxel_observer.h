#pragma once

#include "fusion/lanes.h"
#include "fusion/range_image.h"

namespace citrine::fusion {

/// What one scan says about eight voxels.
struct Observation {
  Mask said;     ///< whether it says anything
  Mask in_band;  ///< whether it saw a surface within the truncation
  Lanes sdf_m;   ///< signed distance, within +-truncation
  Lanes weight;  ///< 1/r^2, r the range of the surface [1/m^2]
  Lanes share;   ///< of the weight, for averaging: less behind the surface and at edges of depth
};

/// Looks voxels up in a range image: their distance to the surface that the surrounding four beams show.
///
/// Where the four show one surface, the distance is measured along its normal, known from the slope of
/// inverse range, and the image is asked again at the foot of the perpendicular whether the surface really
/// extends there. Elsewhere the nearest beam speaks alone, and only for voxels next to it.
class VoxelObserver {
 public:
  VoxelObserver(const RangeImage& image, double voxel_m, double truncation_m);

  /// @param x,y,z  [m] voxel centres in the sensor frame
  Observation Observe(Lanes x, Lanes y, Lanes z) const;

 private:
  struct Pixel {
    Lanes row, col;  ///< fractional
  };
  /// Inverse ranges of the four beams around a pixel, and where between them it lies.
  struct Cell {
    Lanes q00, q01, q10, q11;  ///< row, column
    Lanes row_share, col_share;
    Mask one_surface;
    Lanes Interpolated() const { return Mix(Mix(q00, q01, col_share), Mix(q10, q11, col_share), row_share); }
  };
  Cell CellAt(const Pixel& pixel) const;
  Observation AlongNormal(const Cell& cell, const Pixel& pixel, Lanes distance_m, Lanes cos_elevation) const;
  Observation AlongBeam(const Cell& cell, Lanes distance_m, Lanes cos_elevation) const;

  const float* inverse_range_;
  const int* one_surface_;
  int stride_;
  float rows_, cols_;
  float elevation_min_, row_step_, col_step_, per_row_, per_col_;
  float range_max_m_, voxel_m_, truncation_m_;
};

}  // namespace citrine::fusion
