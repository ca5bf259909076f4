#include "modules/runtime/log_digest.h"

#include "modules/channels.h"

namespace citrine {

void LogDigest::Add(const LogEvent& event) {
  if (event.channel == channels::kModuleHealth.name || event.channel == channels::kMissionConfig.name) return;
  digest_.Add(event.channel.c_str(), event.channel.size() + 1);
  digest_.Add(event.bytes.data(), event.bytes.size());
}

}  // namespace citrine
