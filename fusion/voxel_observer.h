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
  Lanes looked;  ///< 1/r^2, r the distance of the voxel itself [1/m^2]
};

/// Looks voxels up in a range image: their distance to the surface that the surrounding four beams show.
///
/// Where the four show one surface, the distance is measured along its normal, known from the slope of
/// inverse range, and the image is asked again at the foot of the perpendicular whether the surface really
/// extends there. Elsewhere the nearest beam speaks alone, and only for voxels next to it.
class VoxelObserver {
 public:
  /// @param image  must outlive the observer
  VoxelObserver(const RangeImage& image, double voxel_m, double truncation_m);

  /// [pixels] of a direction: row 0 and column 0 are those of the first beams.
  struct Pixel {
    Lanes row, col;
  };
  Pixel PixelOf(Lanes x, Lanes y, Lanes z) const {
    return {(AtanRight(z, Sqrt(x * x + y * y)) - elevation_min_) * per_row_,
            MulAdd(Atan2(y, x), per_col_, centre_col_)};
  }
  float rows_a_radian() const { return per_row_; }
  float cols_a_radian() const { return per_col_; }

  /// Inverse ranges of the four beams around a pixel, and where between them it lies.
  struct Cell {
    LanePair lower, upper;  ///< of two rows; columns to the left and right
    Lanes row_share, col_share;
    Mask one_surface;
    Lanes Interpolated() const {
      return Mix(Mix(lower.first, lower.second, col_share), Mix(upper.first, upper.second, col_share),
                 row_share);
    }
  };
  /// Eight voxels and the cells that their beams pass.
  struct Look {
    Mask in_view;
    Lanes distance_m, level_m;  ///< from the sensor, and from its axis
    Pixel pixel;
    Cell cell;
  };
  /// @param x,y,z  [m] voxel centres in the sensor frame
  Look LookAt(Lanes x, Lanes y, Lanes z) const;
  Observation Observe(const Look& look) const;

 private:
  /// The plane n.p = c through the returns of a cell: g = n/c has q = g.u along the beam, and the slopes of q
  /// across it.
  struct Plane {
    Lanes q, up, left, per_g;  ///< the last 1/|g|
  };
  Cell CellAt(const Pixel& pixel) const;
  Plane PlaneOf(const Cell& cell, Lanes per_cos_elevation) const;
  Observation AlongNormal(const Cell& cell, const Pixel& pixel, Lanes distance_m,
                          Lanes per_cos_elevation) const;
  Observation AlongBeam(const Cell& cell, Lanes distance_m, Lanes level_m) const;

  static constexpr float kDoubtful = 0.25f;  // share of the weight of an observation at an edge of depth
  static constexpr float kBeamRadius_vox = 0.65f;  // how far beside a single beam it speaks for voxels

  const float* inverse_range_;
  int stride_;
  float last_row_, last_cell_;
  float elevation_min_, row_step_, col_step_, per_row_, per_col_, centre_col_, last_col_;
  float range_max_m_, voxel_m_, truncation_m_;
};

inline VoxelObserver::VoxelObserver(const RangeImage& image, double voxel_m, double truncation_m)
    : inverse_range_(image.inverse_range()),
      stride_(image.stride()),
      last_row_(static_cast<float>(image.model().rows - 1)),
      last_cell_(static_cast<float>(image.rows() - 2)),
      elevation_min_(static_cast<float>(image.model().elevation_min_rad)),
      row_step_(static_cast<float>(image.model().rows > 1 ? image.model().row_step_rad()
                                                          : image.model().col_step_rad())),
      col_step_(static_cast<float>(image.model().col_step_rad())),
      per_row_(1 / row_step_),
      per_col_(1 / col_step_),
      centre_col_(0.5f * static_cast<float>(image.model().cols - 1)),
      last_col_(static_cast<float>(image.model().cols + RangeImage::kTurnedRight - 2)),
      range_max_m_(static_cast<float>(image.model().range_max_m)),
      voxel_m_(static_cast<float>(voxel_m)),
      truncation_m_(static_cast<float>(truncation_m)) {}

inline VoxelObserver::Cell VoxelObserver::CellAt(const Pixel& pixel) const {
  Cell cell;
  const Lanes row = Min(Max(Floor(pixel.row), 0.0f), last_cell_);
  cell.row_share = Min(Max(pixel.row - row, 0.0f), 1.0f);
  const Lanes floor_col = Floor(pixel.col);
  cell.col_share = pixel.col - floor_col;
  const Lanes col = Min(Max(floor_col, static_cast<float>(-RangeImage::kTurnedLeft)), last_col_);
  const __m256i index = ToInt(MulAdd(row, static_cast<float>(stride_), col));
  cell.lower = GatherPairs(inverse_range_, index);
  cell.upper = GatherPairs(inverse_range_ + stride_, index);
  cell.one_surface = LowestBit(cell.lower.first) & (pixel.row >= 0.0f) & (pixel.row <= last_row_);
  return cell;
}

inline VoxelObserver::Plane VoxelObserver::PlaneOf(const Cell& cell, Lanes per_cos_elevation) const {
  const Lanes below = Mix(cell.lower.first, cell.lower.second, cell.col_share);
  const Lanes above = Mix(cell.upper.first, cell.upper.second, cell.col_share);
  const Lanes left_end = Mix(cell.lower.second, cell.upper.second, cell.row_share);
  const Lanes right_end = Mix(cell.lower.first, cell.upper.first, cell.row_share);
  Plane plane;
  plane.q = Max(Mix(below, above, cell.row_share), 1e-6f);
  plane.up = (above - below) * per_row_;
  plane.left = (left_end - right_end) * per_col_ * per_cos_elevation;
  plane.per_g =
      Lanes(1.0f) / Sqrt(MulAdd(plane.q, plane.q, MulAdd(plane.up, plane.up, plane.left * plane.left)));
  return plane;
}

inline VoxelObserver::Look VoxelObserver::LookAt(Lanes x, Lanes y, Lanes z) const {
  Look look;
  const Lanes level2 = MulAdd(x, x, y * y);
  look.level_m = Sqrt(level2);
  look.distance_m = Sqrt(MulAdd(z, z, level2));
  look.pixel = {(AtanRight(z, look.level_m) - elevation_min_) * per_row_,
                MulAdd(Atan2(y, x), per_col_, centre_col_)};
  look.in_view = (look.pixel.row >= -0.5f) & (look.pixel.row <= last_row_ + 0.5f) &
                 (look.distance_m < range_max_m_ + truncation_m_) & (look.distance_m > 1e-3f);
  look.cell = CellAt(look.pixel);
  return look;
}

inline Observation VoxelObserver::Observe(const Look& look) const {
  const auto& [in_view, distance_m, level_m, pixel, cell] = look;
  if (!in_view.any())
    return {
        .said = in_view, .in_band = in_view, .sdf_m = 0.0f, .weight = 0.0f, .share = 0.0f, .looked = 0.0f};

  const Lanes per_cos_elevation = Min(distance_m / Max(level_m, 1e-6f), 20.0f);
  const Mask smooth = cell.one_surface;
  Observation observation;
  if (!Without(in_view, smooth).any()) {
    observation = AlongNormal(cell, pixel, distance_m, per_cos_elevation);
  } else {
    observation = AlongBeam(cell, distance_m, level_m);
    if ((smooth & in_view).any()) {
      const Observation normal = AlongNormal(cell, pixel, distance_m, per_cos_elevation);
      observation.said = Select(smooth, normal.said, observation.said);
      observation.in_band = Select(smooth, normal.in_band, observation.in_band);
      observation.sdf_m = Select(smooth, normal.sdf_m, observation.sdf_m);
      observation.weight = Select(smooth, normal.weight, observation.weight);
      observation.share = Select(smooth, normal.share, observation.share);
    }
  }
  observation.looked = Lanes(1.0f) / (distance_m * distance_m);
  const Lanes behind = Max((observation.sdf_m + truncation_m_) * (1 / truncation_m_), 0.0f);
  observation.share = observation.share * Min(behind, 1.0f);
  observation.sdf_m = Min(observation.sdf_m, truncation_m_);
  observation.said = observation.said & in_view & (observation.share > 0.0f);
  observation.in_band = observation.in_band & observation.said;
  return observation;
}

inline Observation VoxelObserver::AlongNormal(const Cell& cell, const Pixel& pixel, Lanes distance_m,
                                              Lanes per_cos_elevation) const {
  const auto [q, up, left, per_g] = PlaneOf(cell, per_cos_elevation);
  const Lanes short_of_surface =
      Lanes(1.0f) - distance_m * q;  // share of the range that lies behind the voxel
  const Lanes perpendicular_m = short_of_surface * per_g;

  // Foot of the perpendicular: its coordinates along the beam, upwards and to the left of it.
  const Lanes per_g2 = perpendicular_m * per_g;
  const Lanes foot_along = MulAdd(per_g2, q, distance_m);
  const Lanes foot_up = per_g2 * up, foot_left = per_g2 * left;
  const Lanes aside2 = MulAdd(foot_up, foot_up, foot_left * foot_left);

  Observation observation;
  observation.sdf_m = perpendicular_m;
  Lanes surface_q = q;  // inverse range of the surface that is spoken of
  Mask doubtful = Mask::Nowhere();
  const Mask to_check = (Abs(perpendicular_m) < truncation_m_) &
                        ((aside2 > voxel_m_ * voxel_m_ * 0.0625f) | (Abs(short_of_surface) > voxel_m_ * q));
  if (to_check.any()) {
    // atan(t) = t - t^3/3 and sqrt(1 + t^2) = 1 + t^2/2, to within 1 % for the angles that matter here.
    const Lanes per_ahead = Lanes(1.0f) / Max(foot_along, 0.25f);
    const auto angle = [&](Lanes aside_m) {
      const Lanes t = aside_m * per_ahead;
      return t * Max(MulAdd(t * t, -0.3333f, 1.0f), 0.5f);
    };
    const Pixel at_foot{MulAdd(angle(foot_up), per_row_, pixel.row),
                        MulAdd(angle(foot_left) * per_cos_elevation, per_col_, pixel.col)};
    const Lanes foot_m = MulAdd(aside2 * 0.5f, per_ahead, foot_along);
    const Cell there = CellAt(at_foot);
    const Lanes there_q = there.Interpolated();
    const Mask is_there = there.one_surface & (Abs(Lanes(1.0f) - foot_m * there_q) < voxel_m_ * there_q);
    doubtful = Without(to_check, is_there);
    surface_q = Select(to_check & is_there, there_q, q);
    if (doubtful.any()) observation.sdf_m = Select(doubtful, short_of_surface / q, perpendicular_m);
  }

  const Mask reaches = short_of_surface >= -truncation_m_ * q * Select(doubtful, 1.0f, 2.0f);
  observation.said = reaches & (observation.sdf_m >= -truncation_m_);
  observation.in_band = observation.said & (observation.sdf_m < truncation_m_);
  observation.weight = surface_q * surface_q;
  observation.share = Select(doubtful, kDoubtful, 1.0f);
  return observation;
}

inline Observation VoxelObserver::AlongBeam(const Cell& cell, Lanes distance_m, Lanes level_m) const {
  const auto [q00, q01] = cell.lower;
  const auto [q10, q11] = cell.upper;
  const Lanes nearest_q = Max(Max(q00, q01), Max(q10, q11));
  const Lanes least_q = Min(Min(q00, q01), Min(q10, q11));
  const Mask within_range = distance_m <= range_max_m_;
  const Mask all_pass = (least_q >= 0.0f) & (nearest_q * (distance_m + truncation_m_) < 1.0f) & within_range;

  const Mask upper = cell.row_share > 0.5f, right = cell.col_share > 0.5f;
  const Lanes q = Select(upper, Select(right, q11, q10), Select(right, q01, q00));
  const Mask returned = q > 0.0f, valid = q >= 0.0f;
  const Lanes sdf_m = Select(returned, Lanes(1.0f) / Max(q, 1e-6f) - distance_m, truncation_m_);
  const Lanes aside_row = (cell.row_share - Keep(upper, 1.0f)) * row_step_ * distance_m;
  const Lanes aside_col = (cell.col_share - Keep(right, 1.0f)) * col_step_ * level_m;
  const Lanes aside2 = MulAdd(aside_row, aside_row, aside_col * aside_col);
  const float radius_m = kBeamRadius_vox * voxel_m_;
  const Mask beside_beam = valid & (aside2 < radius_m * radius_m) & (returned | within_range);

  Observation observation;
  observation.in_band =
      Without(beside_beam & returned & (sdf_m < truncation_m_) & (sdf_m >= -truncation_m_), all_pass);
  const Mask passes = Without(beside_beam & (sdf_m >= truncation_m_), all_pass);
  observation.said = all_pass | observation.in_band | passes;
  observation.sdf_m = Select(observation.in_band, sdf_m, truncation_m_);
  const Lanes surface_q = Select(returned, q, 1 / range_max_m_);
  observation.weight = surface_q * surface_q;
  observation.share = Select(passes, kDoubtful, 1.0f);
  return observation;
}

}  // namespace citrine::fusion
