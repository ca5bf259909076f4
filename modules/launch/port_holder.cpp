#include "modules/launch/port_holder.h"

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace citrine {
namespace {

namespace fs = std::filesystem;

constexpr int kDefaultPort = 7667;

/// Inodes of the sockets that are bound to a port: the tenth column of /proc/net/udp, whose second is
/// address:port.
std::set<std::string> SocketsOn(int port) {
  char wanted[8];
  std::snprintf(wanted, sizeof wanted, ":%04X", static_cast<unsigned>(port));
  std::set<std::string> sockets;
  for (const char* table : {"/proc/net/udp", "/proc/net/udp6"}) {
    std::ifstream in(table);
    for (std::string line; std::getline(in, line);) {
      std::istringstream row(line);
      std::string cell, address;
      for (int column = 0; column < 10 && row >> cell; ++column)
        if (column == 1) address = cell;
      if (address.ends_with(wanted)) sockets.insert("socket:[" + cell + "]");
    }
  }
  return sockets;
}

bool HoldsOneOf(const fs::path& process, const std::set<std::string>& sockets) {
  std::error_code hidden;
  for (const auto& fd : fs::directory_iterator(process / "fd", hidden))
    if (sockets.contains(fs::read_symlink(fd.path(), hidden).string())) return true;
  return false;
}

}  // namespace

int PortOf(const std::string& lcm_url) {
  static const std::regex port(R"(udpm://[^?]*:(\d{1,5})(\?.*)?)");
  std::smatch m;
  return std::regex_match(lcm_url, m, port) ? std::stoi(m[1]) : kDefaultPort;
}

std::string HolderOfPort(const std::string& lcm_url) {
  const std::set<std::string> sockets = SocketsOn(PortOf(lcm_url));
  if (sockets.empty()) return {};
  for (const auto& process : fs::directory_iterator("/proc")) {
    const std::string pid = process.path().filename();
    if (pid.find_first_not_of("0123456789") != std::string::npos || pid == std::to_string(getpid())) continue;
    if (!HoldsOneOf(process.path(), sockets)) continue;
    std::string name;
    std::getline(std::ifstream(process.path() / "comm"), name);
    return "\"" + name + "\" (pid " + pid + ")";
  }
  return {};
}

}  // namespace citrine
