#include "modules/lidar_emulator/lidar_emulator_module.h"
#include "modules/runtime/run_module.h"

int main(int argc, char** argv) { return citrine::RunModule<citrine::LidarEmulatorModule>(argc, argv); }
