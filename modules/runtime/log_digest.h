#pragma once

#include "core/digest.h"
#include "modules/runtime/log_event.h"

namespace citrine {

/// XXH64 over channel, a zero byte and payload of every event in order, without MODULE_HEALTH and
/// MISSION_CONFIG, whose content depends on the host: what metrics.json calls log_digest.
class LogDigest {
 public:
  void Add(const LogEvent& event);
  std::uint64_t value() const { return digest_.value(); }

 private:
  Digest digest_;
};

}  // namespace citrine
