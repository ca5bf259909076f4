#pragma once

namespace citrine {

/// The whole `main` of the recorder: writes all that is said on a bus to an LCM log, in order of arrival,
/// until SIGINT or SIGTERM. Unlike lcm-logger, whose queue holds 30 messages, it loses none to a burst: in
/// lockstep a busy host has bursts.
/// @return exit code: 0 the log is whole, 1 wrong use, 2 the bus or the file cannot be used, 4 the disk is
/// full
int RunRecorder(int argc, char** argv);

}  // namespace citrine
