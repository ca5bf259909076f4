#pragma once

#include <cmath>
#include <cstdint>

namespace citrine {

using Utime = std::int64_t;  ///< [us] mission time; it arrives in messages and is never read from a clock

constexpr double Seconds(Utime utime) { return static_cast<double>(utime) * 1e-6; }
inline Utime FromSeconds(double seconds) { return static_cast<Utime>(std::llround(seconds * 1e6)); }

/// Says when something periodic is due; the first time at `phase`.
class Every {
 public:
  explicit Every(double period_s, Utime phase = 0) : period_(FromSeconds(period_s)), next_(phase) {}

  /// True once per period; a late caller is not made to catch up on the periods that it missed.
  bool Due(Utime now) {
    if (now < next_) return false;
    next_ += period_ * ((now - next_) / period_ + 1);
    return true;
  }

 private:
  Utime period_;
  Utime next_;
};

}  // namespace citrine
