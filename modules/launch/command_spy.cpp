#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "modules/launch/commands.h"
#include "modules/launch/spy_parts.h"

namespace citrine {

int Spy(const SpyOptions& options) {
  const SpyParts parts = FindSpyParts();
  if (!parts.missing.empty()) throw std::runtime_error("spy: " + parts.missing);
  if (!parts.stale.empty()) std::fprintf(stderr, "citrine: spy: %s\n", parts.stale.c_str());
  const std::string url = FindBus(options.source);
  setenv("LCM_DEFAULT_URL", url.c_str(), 1);
  // Java's LCM asks for no receive buffer, and where IPv6 is on it would open the wrong kind of socket.
  std::vector<std::string> words = {"java", "-Djava.net.preferIPv4Stack=true", "-Xmx512m", "-jar", parts.jar};
  if (!options.screenshot.empty()) {
    words.push_back(std::to_string(options.screenshot_after_s));
    words.push_back(options.screenshot);
  }
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execvp(arguments[0], arguments.data());
  throw std::runtime_error(std::string("spy: cannot start java: ") + std::strerror(errno));
}

}  // namespace citrine
