#include "modules/every_channel.h"

#include <charconv>

namespace citrine {

int UavOfChannel(const std::string& channel) {
  constexpr std::string_view kUav = "UAV";
  int uav = 0;
  if (channel.starts_with(kUav))
    std::from_chars(channel.data() + kUav.size(), channel.data() + channel.size(), uav);
  return uav;
}

}  // namespace citrine
