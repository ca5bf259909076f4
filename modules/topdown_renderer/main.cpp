#include "modules/runtime/run_module.h"
#include "modules/topdown_renderer/topdown_renderer_module.h"

int main(int argc, char** argv) { return citrine::RunModule<citrine::TopdownRendererModule>(argc, argv); }
