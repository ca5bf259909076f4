#include "modules/runtime/run_module.h"
#include "modules/uav_dynamics/uav_dynamics_module.h"

int main(int argc, char** argv) { return citrine::RunModule<citrine::UavDynamicsModule>(argc, argv); }
