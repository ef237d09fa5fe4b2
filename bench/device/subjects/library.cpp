// SPDX-License-Identifier: GPL-3.0-or-later
// The subjects of one format of the library, LIBRARY_FORMAT: every operation in the default
// arithmetic, and those that saturate.
#include <fixedpoint/arithmetic/nearest.hpp>
#include <fixedpoint/arithmetic/saturating.hpp>

#include "subject.h"

using fixedpoint::Nearest;
using fixedpoint::Saturating;

IMPLEMENTATION_default(SUBJECTS_IN_FORMAT) IMPLEMENTATION_saturating(SUBJECTS_IN_FORMAT)
