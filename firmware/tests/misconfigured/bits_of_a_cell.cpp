// SPDX-License-Identifier: MIT
// A cell has 1, 2 or 4 bits: 2, 4 or 16 colours, of which 0 is the blank.
#include <firmware/grid.hpp>

template class firmware::Grid<20, 20, 3, false>;
