// RunContext: what a run shares with its caller. Made first; asked for progress, told to stop.
#pragma once

#include "base/error.h"
#include "base/run_context.h"
