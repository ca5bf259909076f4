#include <cstdio>

#include "core/config/config_file.h"
#include "modules/launch/commands.h"

namespace citrine {

int ShowKeys() {
  std::fputs(DescribeKeys().c_str(), stdout);
  return kCompleted;
}

}  // namespace citrine
