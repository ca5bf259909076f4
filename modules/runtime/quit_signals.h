#pragma once

namespace citrine {

/// From now on SIGINT and SIGTERM are remembered instead of ending this process, and the death of its parent
/// is a SIGTERM.
void CatchQuitSignals();

/// A person (or the launcher, for one) wants the mission to end: SIGINT, once.
bool Interrupted();
/// This process is to end now: SIGTERM, or SIGINT twice.
bool Terminated();

}  // namespace citrine
