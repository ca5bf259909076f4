#include "modules/runtime/quit_signals.h"

#include <csignal>

#include <sys/prctl.h>

namespace citrine {
namespace {

volatile std::sig_atomic_t interrupts = 0;
volatile std::sig_atomic_t terminations = 0;

}  // namespace

void CatchQuitSignals() {
  std::signal(SIGINT, [](int) { interrupts = interrupts + 1; });
  std::signal(SIGTERM, [](int) { terminations = terminations + 1; });
  prctl(PR_SET_PDEATHSIG, SIGTERM);
}

bool Interrupted() { return interrupts > 0 || terminations > 0; }
bool Terminated() { return interrupts > 1 || terminations > 0; }

}  // namespace citrine
