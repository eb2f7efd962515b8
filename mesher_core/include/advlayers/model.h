// Model, read_brep(), read_file(): the shape, its faces and edges numbered as FreeCAD has them.
#pragma once

#include "geometry/model.h"
