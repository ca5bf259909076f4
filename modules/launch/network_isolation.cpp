#include "modules/launch/network_isolation.h"

#include <arpa/inet.h>
#include <net/if.h>
#include <net/route.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace citrine {
namespace {

void Require(bool succeeded, const char* what) {
  if (!succeeded) throw std::runtime_error(std::string(what) + ": " + std::strerror(errno));
}

void Write(const char* file, const std::string& text) {
  std::ofstream out(file);
  out << text << std::flush;
  Require(out.good(), file);
}

/// Who is not root becomes the owner of a user namespace first; there everybody keeps the id that files know.
void Unshare() {
  if (geteuid() == 0 && unshare(CLONE_NEWNET) == 0) return;
  const std::string uid = std::to_string(geteuid()), gid = std::to_string(getegid());
  Require(unshare(CLONE_NEWUSER | CLONE_NEWNET) == 0, "no network namespace of its own");
  Write("/proc/self/setgroups", "deny");
  Write("/proc/self/uid_map", uid + " " + uid + " 1");
  Write("/proc/self/gid_map", gid + " " + gid + " 1");
}

struct Socket {
  int fd = socket(AF_INET, SOCK_DGRAM, 0);
  ~Socket() { close(fd); }
};

void RaiseLoopback(int fd) {
  ifreq request{};
  std::strcpy(request.ifr_name, "lo");
  Require(ioctl(fd, SIOCGIFFLAGS, &request) == 0, "no loopback interface");
  request.ifr_flags = static_cast<short>(request.ifr_flags | IFF_UP | IFF_MULTICAST);
  Require(ioctl(fd, SIOCSIFFLAGS, &request) == 0, "cannot raise the loopback interface");
}

sockaddr Address(const char* text) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  inet_pton(AF_INET, text, &address.sin_addr);
  sockaddr plain{};
  std::memcpy(&plain, &address, sizeof plain);
  return plain;
}

void RouteMulticastToLoopback(int fd) {
  rtentry route{};
  char device[] = "lo";
  route.rt_dst = Address("224.0.0.0");
  route.rt_genmask = Address("240.0.0.0");
  route.rt_flags = RTF_UP;
  route.rt_dev = device;
  Require(ioctl(fd, SIOCADDRT, &route) == 0, "cannot route multicast over the loopback interface");
}

}  // namespace

std::optional<std::string> IsolateNetwork() {
  try {
    Unshare();
    const Socket socket;
    RaiseLoopback(socket.fd);
    RouteMulticastToLoopback(socket.fd);
    return std::nullopt;
  } catch (const std::runtime_error& refusal) {
    return refusal.what();
  }
}

}  // namespace citrine
