// SPDX-License-Identifier: GPL-3.0-or-later
// The subjects of one format of the library, LIBRARY_FORMAT: every operation in the default
// arithmetic.
#include <fixedpoint/arithmetic/nearest.hpp>

#include "subject.h"

using fixedpoint::Nearest;

IMPLEMENTATION_default(SUBJECTS_IN_FORMAT)
