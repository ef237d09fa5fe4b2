// SPDX-License-Identifier: MIT
// A grid has 1 to 99 columns and 1 to 90 rows, as a terminal addresses them.
#include <firmware/grid.hpp>

template class firmware::Grid<120, 20, 2, false>;
