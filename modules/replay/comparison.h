#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "modules/runtime/log_event.h"

namespace citrine {

/// How far what is said may be from what was recorded.
struct Tolerance {
  double number = 0;        ///< of a real number, absolute
  double number_share = 0;  ///< the same, relative to the recorded one
  int count = 0;            ///< of a count or a voxel's code, absolute
  double count_share = 0;   ///< the same, relative to the recorded one
  Utime time = 0;           ///< [us] by which a message may come sooner or later
  bool digests = true;      ///< compares digests and packed streams, of which one bit changes all
  bool bookkeeping = true;  ///< compares seq, ids and versions, and MAP_BLOCKS voxel by voxel
};

/// In process and in lockstep: to the bit.
inline constexpr Tolerance kIdentical{};
/// The same recording on another kind of processor, whose libraries may round otherwise.
inline constexpr Tolerance kOtherProcessor{1e-6, 1e-6, 1, 0, 0, false, true};
/// At the pace of the wall, where a module may have heard a message a step sooner or later than the log
/// shows: about then the same was said, in metres, radians, percent and seconds. A trajectory is compared by
/// where it leads, every half second.
inline constexpr Tolerance kPaced{0.3, 0.02, 5, 0.1, 500'000, false, false};

/// Where a replay first says something else.
struct Difference {
  std::string channel;
  Utime utime = 0;
  std::int64_t seq = 0;
  std::string field;           ///< empty: the whole message
  std::string recorded, said;  ///< values of the field; "nothing" for a message that is missing

  /// "UAV1_PATH at t = 12.40 s, message 31: x_W[2] is 4.1, recorded 4.35"
  std::string Text() const;
};

struct Comparison {
  std::int64_t recorded = 0, said = 0;  ///< messages
  std::int64_t different = 0;           ///< recorded messages whose like was not said, and the reverse
  std::optional<Difference> first;      ///< in mission time
  bool first_is_decision = false;       ///< see IsDecision
};

/// Holds what a module said against what was recorded of it; both in canonical order (LogEvent).
Comparison Compare(const std::vector<LogEvent>& recorded, const std::vector<LogEvent>& said,
                   const Tolerance& tolerance);

}  // namespace citrine
