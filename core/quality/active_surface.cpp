#include "core/quality/active_surface.h"

#include <immintrin.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "core/quality/confidence.h"

namespace citrine {

namespace {

int LowestReachedCode(const Quantisation& quantisation, double w_star) {
  int code = 1;
  while (code < 255 && quantisation.Weight(static_cast<std::uint8_t>(code)) < kReached * w_star) ++code;
  return code;
}

}  // namespace

ActiveSurface::ActiveSurface(const VoxelGrid& grid, const Quantisation& quantisation, QualityGoals goals)
    : grid_(grid), goals_(std::move(goals)) {
  for (int code = 1; code < 256; ++code) {
    if (std::abs(quantisation.Distance(static_cast<std::uint8_t>(code))) >= grid.voxel_m()) continue;
    band_first_ = std::min(band_first_, code);
    band_last_ = code;
  }
  reached_code_whole_ = LowestReachedCode(quantisation, goals_.whole().w_star);
  for (const QualityGoals::Region& region : goals_.regions())
    reached_code_of_region_.push_back(LowestReachedCode(quantisation, region.goal.w_star));
  class_.resize(grid.num_voxels());
  active_in_row_.resize(static_cast<std::size_t>(grid.voxels().y()) * grid.voxels().z());
  version_.resize(grid.num_blocks());
  unknown_.resize(grid.num_blocks(), kBlockVoxels);
  discovered_.resize(grid.num_blocks());
}

bool ActiveSurface::Update(const PlanningMap& map) {
  bool changed = false;
  for (int block = 0; block < grid_.num_blocks(); ++block) {
    if (map.block_version(block) == version_[block]) continue;
    version_[block] = map.block_version(block);
    Recompute(map, block);
    changed = true;
  }
  if (changed) List();
  return changed;
}

/// The classes of a block and of two voxels around it, one bit a voxel in a row along x. Voxels outside the
/// mission volume are of no class.
struct ActiveSurface::Neighbourhood {
  static constexpr int kSide = kBlockSide + 4;
  using Rows = std::array<unsigned, kSide * kSide>;
  Rows unknown{}, empty{}, occupied{}, in_band{};

  static std::size_t At(int y, int z) { return static_cast<std::size_t>(y + kSide * z); }
  static unsigned Face(const Rows& rows, std::size_t at) {
    return rows[at] << 1 | rows[at] >> 1 | rows[at - 1] | rows[at + 1] | rows[at - kSide] | rows[at + kSide];
  }
  static unsigned Wide(unsigned row) { return row << 1 | row | row >> 1; }

  unsigned Incomplete(std::size_t at) const {
    const unsigned edge = empty[at] & Face(unknown, at);
    if (!edge) return 0;
    const Rows& o = occupied;
    return edge & (o[at] << 1 | o[at] >> 1 | Wide(o[at - 1] | o[at + 1] | o[at - kSide] | o[at + kSide]) |
                   o[at - kSide - 1] | o[at - kSide + 1] | o[at + kSide - 1] | o[at + kSide + 1]);
  }
  unsigned Surface(std::size_t at) const { return in_band[at] ? in_band[at] & Face(empty, at) : 0; }
};

void ActiveSurface::Recompute(const PlanningMap& map, int block) {
  const VoxelIndex origin = grid_.BlockOrigin(block);
  const std::int32_t unknown = CountUnknown(map, origin);
  if (unknown < unknown_[block]) discovered_[block] = last_discovery_ = map.revision();
  unknown_[block] = unknown;

  constexpr int kSide = Neighbourhood::kSide;
  const VoxelIndex corner = origin.array() - 2;
  const VoxelIndex low = corner.cwiseMax(grid_.inside_min()) - corner;
  const VoxelIndex high = (corner.array() + kSide).min(grid_.inside_max().array()).matrix() - corner;
  if ((low.array() >= high.array()).any()) return;
  const int width = high.x() - low.x();
  const unsigned inside = ((1u << width) - 1) << low.x();
  Neighbourhood near;
  alignas(16) std::array<std::uint8_t, 16> states{}, codes{};
  for (int z = low.z(); z < high.z(); ++z)
    for (int y = low.y(); y < high.y(); ++y) {
      const std::size_t first = grid_.Linear(corner + VoxelIndex(low.x(), y, z)),
                        at = Neighbourhood::At(y, z);
      std::memcpy(&states[low.x()], &map.states()[first], width);
      std::memcpy(&codes[low.x()], &map.distance_codes()[first], width);
      const __m128i row = _mm_load_si128(reinterpret_cast<const __m128i*>(states.data()));
      const auto of = [&](VoxelState state) {
        const __m128i same = _mm_cmpeq_epi8(row, _mm_set1_epi8(static_cast<char>(state)));
        return static_cast<unsigned>(_mm_movemask_epi8(same)) & inside;
      };
      near.unknown[at] = of(VoxelState::kUnknown);
      near.empty[at] = of(VoxelState::kEmpty);
      near.occupied[at] = of(VoxelState::kOccupied);
      const __m128i code = _mm_load_si128(reinterpret_cast<const __m128i*>(codes.data()));
      const __m128i first_code = _mm_set1_epi8(static_cast<char>(band_first_));
      const __m128i last_code = _mm_set1_epi8(static_cast<char>(band_last_));
      const __m128i banded = _mm_and_si128(_mm_cmpeq_epi8(_mm_max_epu8(code, first_code), code),
                                           _mm_cmpeq_epi8(_mm_min_epu8(code, last_code), code));
      near.in_band[at] = static_cast<unsigned>(_mm_movemask_epi8(banded)) & inside & ~near.empty[at];
    }

  const VoxelIndex min = low.cwiseMax(1), max = high.cwiseMin(kSide - 1);
  const unsigned own = ((1u << (max.x() - min.x())) - 1) << min.x();
  for (int z = min.z(); z < max.z(); ++z)
    for (int y = min.y(); y < max.y(); ++y) {
      const std::size_t at = Neighbourhood::At(y, z);
      WriteRow(map, corner + VoxelIndex(min.x(), y, z), max.x() - min.x(),
               (near.Incomplete(at) & own) >> min.x(), (near.Surface(at) & own) >> min.x());
    }
}

std::int32_t ActiveSurface::CountUnknown(const PlanningMap& map, const VoxelIndex& origin) const {
  constexpr std::uint64_t kLowBits = 0x0101010101010101u;
  std::int32_t known = 0;
  for (int z = 0; z < kBlockSide; ++z)
    for (int y = 0; y < kBlockSide; ++y) {
      std::uint64_t eight;
      std::memcpy(&eight, &map.states()[grid_.Linear(origin + VoxelIndex(0, y, z))], sizeof eight);
      known += std::popcount((eight | eight >> 1) & kLowBits);
    }
  return kBlockVoxels - known;
}

/// @param incomplete, surface  bit i: voxel i of the row is empty and incomplete, or a surface voxel
void ActiveSurface::WriteRow(const PlanningMap& map, const VoxelIndex& first, int count, unsigned incomplete,
                             unsigned surface) {
  const std::size_t begin = grid_.Linear(first);
  std::array<std::uint8_t, 16> before{};
  std::memcpy(before.data(), &class_[begin], count);
  if (!(incomplete | surface) && before == std::array<std::uint8_t, 16>{}) return;
  std::int32_t& active = active_in_row_[begin / grid_.stride_y()];
  for (int i = 0; i < count; ++i) {
    SurfaceClass now = SurfaceClass::kNone;
    if (incomplete >> i & 1) {
      now = SurfaceClass::kIse;
    } else if (surface >> i & 1) {
      const bool reached = map.weight_code(begin + i) >= ReachedCode(first + VoxelIndex(i, 0, 0));
      now = reached ? SurfaceClass::kReached : SurfaceClass::kLqse;
    }
    const auto was = static_cast<SurfaceClass>(before[i]);
    --counts_[static_cast<int>(was)];
    ++counts_[static_cast<int>(now)];
    active += (now >= SurfaceClass::kLqse) - (was >= SurfaceClass::kLqse);
    class_[begin + i] = static_cast<std::uint8_t>(now);
  }
}

int ActiveSurface::ReachedCode(const VoxelIndex& v) const {
  if (goals_.regions().empty()) return reached_code_whole_;
  const Eigen::Vector3d p_W = grid_.Centre(v);
  for (std::size_t i = 0; i < goals_.regions().size(); ++i)
    if (goals_.regions()[i].box_W.contains(p_W)) return reached_code_of_region_[i];
  return reached_code_whole_;
}

void ActiveSurface::List() {
  elements_.clear();
  const std::size_t width = grid_.stride_y();
  for (std::size_t row = 0; row < active_in_row_.size(); ++row) {
    std::int32_t left = active_in_row_[row];
    for (std::size_t i = row * width; left > 0; i += kBlockSide) {
      std::uint64_t eight;
      std::memcpy(&eight, &class_[i], sizeof eight);
      if (eight == 0) continue;
      for (std::size_t k = i; k < i + kBlockSide; ++k) {
        if (class_[k] < static_cast<std::uint8_t>(SurfaceClass::kLqse)) continue;
        elements_.push_back(static_cast<std::uint32_t>(k));
        --left;
      }
    }
  }
}

}  // namespace citrine
