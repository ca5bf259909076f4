#pragma once

#include <algorithm>

#include "core/time.h"

namespace citrine {

/// Paces bulk over mission time: so many bytes a second, and no more than a burst at once.
class TokenBucket {
 public:
  TokenBucket(double bytes_per_s, double burst_bytes)
      : bytes_per_s_(bytes_per_s), burst_bytes_(burst_bytes), tokens_(burst_bytes) {}

  void Refill(Utime now) {
    tokens_ = std::min(burst_bytes_, tokens_ + Seconds(now - last_) * bytes_per_s_);
    last_ = now;
  }

  /// Whether `bytes` may be said now; one message larger than the burst passes when the bucket is full.
  bool Take(double bytes) {
    if (tokens_ < std::min(bytes, burst_bytes_)) return false;
    tokens_ -= bytes;
    return true;
  }

 private:
  double bytes_per_s_, burst_bytes_, tokens_;
  Utime last_ = 0;
};

}  // namespace citrine
