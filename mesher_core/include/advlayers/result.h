// MeshResult: the finished mesh as plain arrays, with what it says of patches and walls.
#pragma once

#include "mesher/result.h"
