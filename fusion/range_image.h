#pragma once

#include <cstdint>
#include <vector>

#include "core/sensor/lidar_scan.h"

namespace citrine::fusion {

/// One scan as an image of inverse ranges (rows: elevation, columns: azimuth), ready to be looked up by
/// direction.
///
/// Inverse range is linear in the direction's vector on a plane, whatever its incidence: q = n.u / c for n.p
/// = c. So it is interpolated instead of the range, and planes seen at a grazing angle are known by it.
class RangeImage {
 public:
  /// Columns that are there beyond the first and last of the model: those of the next turn.
  static constexpr int kTurnedLeft = 8, kTurnedRight = 24;

  /// Takes a scan in; memory of the one before is used again.
  /// @param voxel_m  how far two neighbouring returns may lie apart and still belong to one surface
  /// @throws std::invalid_argument if there is not one range a beam
  void Take(const LidarScan& scan, double voxel_m);

  const LidarModel& model() const { return model_; }
  /// At least two, the last repeated where the model has one.
  int rows() const { return rows_; }
  /// From one row to the next.
  int stride() const { return stride_; }

  /// [1/m] of beam (0, 0); 0: no return, -1: invalid. The lowest bit of a return's number says whether the
  /// cell between (row, col) and (row + 1, col + 1) shows one continuous surface.
  const float* inverse_range() const { return &inverse_range_[kTurnedLeft + stride_]; }

 private:
  void LinkNeighbours(double voxel_m);
  /// Fills in the columns beyond the model's.
  void Turn(float* row) const;

  LidarModel model_;
  int rows_ = 0, stride_ = 0;
  std::vector<float> inverse_range_;      ///< an invalid row before the first, two after the last
  std::vector<std::uint32_t> up_, left_;  ///< of a row or two: whether a beam and the next show one surface
};

}  // namespace citrine::fusion
