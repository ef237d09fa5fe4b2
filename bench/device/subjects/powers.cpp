// SPDX-License-Identifier: GPL-3.0-or-later
// Powers and logarithms of one format of the library, LIBRARY_FORMAT, for which the program of its
// other subjects has no room.
#include <fixedpoint/arithmetic/nearest.hpp>

#include "subject.h"

using fixedpoint::Nearest;

IMPLEMENTATION_powers(SUBJECTS_IN_FORMAT)
