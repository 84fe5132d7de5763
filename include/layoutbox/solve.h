// Scene graph to layout: solve(), solve_variants().
#pragma once

#include "layoutbox/solve/cp_sat_folder.h"
#include "layoutbox/solve/solver.h"
