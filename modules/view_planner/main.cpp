#include "modules/runtime/run_module.h"
#include "modules/view_planner/view_planner_module.h"

int main(int argc, char** argv) { return citrine::RunModule<citrine::ViewPlannerModule>(argc, argv); }
