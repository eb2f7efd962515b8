// Model, read_brep(), read_file(): the shape, its faces and edges numbered as FreeCAD has them.
// A program that reads files tells where advlayers-read lies: set_reader_program().
#pragma once

#include "geometry/file_gate.h"
#include "geometry/model.h"
