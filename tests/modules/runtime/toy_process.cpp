#include <cstdio>
#include <cstring>

#include "core/config/config_file.h"
#include "modules/runtime/in_process.h"
#include "modules/runtime/log_digest.h"
#include "modules/runtime/log_reader.h"
#include "modules/runtime/run_module.h"
#include "modules/runtime/run_recorder.h"
#include "tests/modules/runtime/toy_modules.h"

// toy_process MODULE [flags of a module]   the process of one toy module
// toy_process in_process                   the mission in one process; prints the log's digest
// toy_process record LOG                   records the bus until it is told to stop
// toy_process digest LOG                   prints the digest of a recording, put in order
int main(int argc, char** argv) {
  using namespace citrine;
  if (argc < 2) return 1;
  for (const ModuleKind& kind : ToyKinds())
    if (kind.name == argv[1]) return RunModule(kind, argc - 1, argv + 1);
  if (std::strcmp(argv[1], "record") == 0) return RunRecorder(argc - 1, argv + 1);
  LogDigest digest;
  if (std::strcmp(argv[1], "digest") == 0 && argc == 3)
    for (const LogEvent& event : ReadInOrder(argv[2])) digest.Add(event);
  else
    RunInProcess(ParseMission("", {"launch.pace=0"}), ToyKinds(),
                 {[&](const LogEvent& event) { digest.Add(event); }, {}, {}});
  std::printf("%s\n", Hex(digest.value()).c_str());
}
