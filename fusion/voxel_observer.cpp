#include "fusion/voxel_observer.h"

namespace citrine::fusion {
namespace {

constexpr float kPi = 3.14159265359f;
constexpr float kDoubtful = 0.25f;        // share of the weight of an observation at an edge of depth
constexpr float kBeamRadius_vox = 0.65f;  // how far beside a single beam it speaks for voxels

}  // namespace

VoxelObserver::VoxelObserver(const RangeImage& image, double voxel_m, double truncation_m)
    : inverse_range_(image.inverse_range()),
      one_surface_(image.one_surface()),
      stride_(image.stride()),
      rows_(static_cast<float>(image.model().rows)),
      cols_(static_cast<float>(image.model().cols)),
      elevation_min_(static_cast<float>(image.model().elevation_min_rad)),
      row_step_(static_cast<float>(image.model().rows > 1 ? image.model().row_step_rad()
                                                          : image.model().col_step_rad())),
      col_step_(static_cast<float>(image.model().col_step_rad())),
      per_row_(1 / row_step_),
      per_col_(1 / col_step_),
      range_max_m_(static_cast<float>(image.model().range_max_m)),
      voxel_m_(static_cast<float>(voxel_m)),
      truncation_m_(static_cast<float>(truncation_m)) {}

VoxelObserver::Cell VoxelObserver::CellAt(const Pixel& pixel) const {
  Cell cell;
  const Lanes last_row = Max(Lanes(rows_ - 2), 0.0f);
  const Lanes row = Min(Max(Floor(pixel.row), 0.0f), last_row);
  cell.row_share = Min(Max(pixel.row - row, 0.0f), 1.0f);
  Lanes col = Floor(pixel.col);
  cell.col_share = pixel.col - col;
  col = Select(col < 0.0f, col + cols_, col);
  col = Select(col >= cols_, col - cols_, col);
  col = Min(Max(col, 0.0f), cols_ - 1);
  const __m256i index = ToInt(row * static_cast<float>(stride_) + col);
  cell.q00 = Gather(inverse_range_, index);
  cell.q01 = Gather(inverse_range_ + 1, index);
  cell.q10 = Gather(inverse_range_ + stride_, index);
  cell.q11 = Gather(inverse_range_ + stride_ + 1, index);
  cell.one_surface = GatherMask(one_surface_, index);
  return cell;
}

Observation VoxelObserver::Observe(Lanes x, Lanes y, Lanes z) const {
  const Lanes level2 = x * x + y * y, level = Sqrt(level2), distance_m = Sqrt(level2 + z * z);
  const Pixel pixel{(Atan2(z, level) - elevation_min_) * per_row_, (Atan2(y, x) + kPi) * per_col_ - 0.5f};
  const Mask in_view = (pixel.row >= -0.5f) & (pixel.row <= rows_ - 0.5f) &
                       (distance_m < range_max_m_ + truncation_m_) & (distance_m > 1e-3f);
  if (!in_view.any())
    return {.said = in_view, .in_band = in_view, .sdf_m = 0.0f, .weight = 0.0f, .share = 0.0f};

  const Lanes cos_elevation = Max(level / Max(distance_m, 1e-3f), 0.05f);
  const Cell cell = CellAt(pixel);
  const Mask between_rows = (pixel.row >= 0.0f) & (pixel.row <= rows_ - 1);
  const Mask smooth = cell.one_surface & between_rows;
  Observation observation = AlongBeam(cell, distance_m, cos_elevation);
  if ((smooth & in_view).any()) {
    const Observation normal = AlongNormal(cell, pixel, distance_m, cos_elevation);
    observation.said = (normal.said & smooth) | Without(observation.said, smooth);
    observation.in_band = (normal.in_band & smooth) | Without(observation.in_band, smooth);
    observation.sdf_m = Select(smooth, normal.sdf_m, observation.sdf_m);
    observation.weight = Select(smooth, normal.weight, observation.weight);
    observation.share = Select(smooth, normal.share, observation.share);
  }
  const Lanes behind = Max((observation.sdf_m + truncation_m_) / truncation_m_, 0.0f);
  observation.share = observation.share * Min(behind, 1.0f);
  observation.sdf_m = Min(observation.sdf_m, truncation_m_);
  observation.said = observation.said & in_view & (observation.share > 0.0f);
  observation.in_band = observation.in_band & observation.said;
  return observation;
}

Observation VoxelObserver::AlongNormal(const Cell& cell, const Pixel& pixel, Lanes distance_m,
                                       Lanes cos_elevation) const {
  // The plane n.p = c through the returns: g = n/c has q = g.u along the beam, and the slopes of q across it.
  const Lanes q = Max(cell.Interpolated(), 1e-6f), range_m = Lanes(1.0f) / q;
  const Lanes up =
      (Mix(cell.q10, cell.q11, cell.col_share) - Mix(cell.q00, cell.q01, cell.col_share)) * per_row_;
  const Lanes left = (Mix(cell.q01, cell.q11, cell.row_share) - Mix(cell.q00, cell.q10, cell.row_share)) *
                     per_col_ / cos_elevation;
  const Lanes g = Sqrt(q * q + up * up + left * left);
  const Lanes cos_incidence = q / g;
  const Lanes along_m = range_m - distance_m, perpendicular_m = along_m * cos_incidence;

  // Foot of the perpendicular: its coordinates along the beam, upwards and to the left of it.
  const Lanes foot_along = distance_m + perpendicular_m * cos_incidence;
  const Lanes foot_up = perpendicular_m * up / g, foot_left = perpendicular_m * left / g;
  const Lanes aside2 = foot_up * foot_up + foot_left * foot_left;
  const Lanes foot_m = Sqrt(foot_along * foot_along + aside2);

  const Mask near_surface = Abs(perpendicular_m) < truncation_m_;
  const Mask to_check = near_surface & (aside2 > voxel_m_ * voxel_m_ * 0.0625f);
  Mask doubtful = Without(to_check, to_check);
  if (to_check.any()) {
    const Lanes ahead = Max(foot_along, 1e-3f);
    const Pixel at_foot{pixel.row + Atan2(foot_up, ahead) * per_row_,
                        pixel.col + Atan2(foot_left, ahead) / cos_elevation * per_col_};
    const Cell there = CellAt(at_foot);
    const Lanes there_m = Lanes(1.0f) / Max(there.Interpolated(), 1e-6f);
    const Mask in_image = (at_foot.row >= 0.0f) & (at_foot.row <= rows_ - 1);
    doubtful = Without(to_check, there.one_surface & in_image & (Abs(there_m - foot_m) < voxel_m_));
  }

  Observation observation;
  observation.sdf_m = Select(doubtful, along_m, perpendicular_m);
  const Mask reaches = Select(doubtful, along_m, along_m * 0.5f) >= -truncation_m_;
  observation.said = reaches & (observation.sdf_m >= -truncation_m_);
  observation.in_band = observation.said & (observation.sdf_m < truncation_m_);
  const Lanes surface_m = Select(Without(observation.in_band, doubtful), foot_m, range_m);
  observation.weight = Lanes(1.0f) / (surface_m * surface_m);
  observation.share = Select(doubtful, kDoubtful, 1.0f);
  return observation;
}

Observation VoxelObserver::AlongBeam(const Cell& cell, Lanes distance_m, Lanes cos_elevation) const {
  const Lanes nearest_q = Max(Max(cell.q00, cell.q01), Max(cell.q10, cell.q11));
  const Lanes least_q = Min(Min(cell.q00, cell.q01), Min(cell.q10, cell.q11));
  const Mask within_range = distance_m <= range_max_m_;
  const Mask all_pass = (least_q >= 0.0f) & (nearest_q * (distance_m + truncation_m_) < 1.0f) & within_range;

  const Mask upper = cell.row_share > 0.5f, right = cell.col_share > 0.5f;
  const Lanes q = Select(upper, Select(right, cell.q11, cell.q10), Select(right, cell.q01, cell.q00));
  const Mask returned = q > 0.0f, valid = q >= 0.0f;
  const Lanes range_m = Select(returned, Lanes(1.0f) / Max(q, 1e-6f), range_max_m_);
  const Lanes sdf_m = Select(returned, range_m - distance_m, truncation_m_);
  const Lanes aside_row = (cell.row_share - Select(upper, 1.0f, 0.0f)) * row_step_;
  const Lanes aside_col = (cell.col_share - Select(right, 1.0f, 0.0f)) * col_step_ * cos_elevation;
  const Lanes aside2 = (aside_row * aside_row + aside_col * aside_col) * distance_m * distance_m;
  const float radius_m = kBeamRadius_vox * voxel_m_;
  const Mask beside_beam = valid & (aside2 < radius_m * radius_m) & (returned | within_range);

  Observation observation;
  observation.in_band =
      Without(beside_beam & returned & (sdf_m < truncation_m_) & (sdf_m >= -truncation_m_), all_pass);
  const Mask passes = Without(beside_beam & (sdf_m >= truncation_m_), all_pass);
  observation.said = all_pass | observation.in_band | passes;
  observation.sdf_m = Select(observation.in_band, sdf_m, truncation_m_);
  observation.weight = Lanes(1.0f) / (range_m * range_m);
  observation.share = Select(passes, kDoubtful, 1.0f);
  return observation;
}

}  // namespace citrine::fusion
