// SPDX-License-Identifier: GPL-3.0-or-later
// Tangents, arc functions and what saturates in one format of the library, LIBRARY_FORMAT, for
// which the program of its other subjects has no room.
#include <fixedpoint/arithmetic/nearest.hpp>
#include <fixedpoint/arithmetic/saturating.hpp>

#include "subject.h"

using fixedpoint::Nearest;
using fixedpoint::Saturating;

IMPLEMENTATION_angles(SUBJECTS_IN_FORMAT) IMPLEMENTATION_saturating(SUBJECTS_IN_FORMAT)
