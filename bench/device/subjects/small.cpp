// SPDX-License-Identifier: GPL-3.0-or-later
// The functions optimised for flash instead of time.
#include <fixedpoint/arithmetic/small.hpp>

#include "subject.h"

using fixedpoint::Small;

IMPLEMENTATION_small(SUBJECTS)
