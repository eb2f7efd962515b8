// The program that reads CAD files for the core: whatever crashes or never ends does so here.
#include "base/child_process.h"
#include "geometry/file_gate.h"

int main() { advlayers::answer_parent(&advlayers::brep_asked_for); }
