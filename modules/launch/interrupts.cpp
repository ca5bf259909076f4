#include "modules/launch/interrupts.h"

#include <csignal>

namespace citrine {
namespace {

volatile std::sig_atomic_t g_interrupts = 0;

}  // namespace

void CountInterrupts() {
  struct sigaction action {};
  action.sa_handler = [](int) { g_interrupts = g_interrupts + 1; };
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

int Interrupts() { return g_interrupts; }

}  // namespace citrine
