// Where a program that links the library has OR-Tools.
#pragma once

#include <filesystem>

namespace layoutbox {

// The folder that is looked in where ORTOOLS_ROOT names none, before the places beside the program. Told before the first solve: what is
// opened stays open.
void set_cp_sat_folder(std::filesystem::path folder);

}  // namespace layoutbox
