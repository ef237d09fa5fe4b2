// SPDX-License-Identifier: GPL-3.0-or-later
// Tangents and arc functions of one format of the library, LIBRARY_FORMAT, for which the program of
// its other subjects has no room.
#include <fixedpoint/arithmetic/nearest.hpp>

#include "subject.h"

using fixedpoint::Nearest;

IMPLEMENTATION_angles(SUBJECTS_IN_FORMAT)
