#include "modules/runtime/run_recorder.h"

int main(int argc, char** argv) { return citrine::RunRecorder(argc, argv); }
