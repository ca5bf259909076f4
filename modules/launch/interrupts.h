#pragma once

namespace citrine {

/// From now on SIGINT and SIGTERM are counted instead of ending this process.
void CountInterrupts();

/// How often the mission was asked to end.
int Interrupts();

}  // namespace citrine
