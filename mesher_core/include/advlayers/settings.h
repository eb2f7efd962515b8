// Settings: what is asked for. Lengths in mm, angles in degrees; checked when a Mesher is made.
#pragma once

#include "sizing/initial_mesh.h"
#include "sizing/settings.h"
