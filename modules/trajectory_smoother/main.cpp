#include "modules/runtime/run_module.h"
#include "modules/trajectory_smoother/trajectory_smoother_module.h"

int main(int argc, char** argv) { return citrine::RunModule<citrine::TrajectorySmootherModule>(argc, argv); }
