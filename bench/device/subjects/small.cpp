// SPDX-License-Identifier: GPL-3.0-or-later
// The functions that take little flash instead of little time.
#include <fixedpoint/arithmetic/small.hpp>

#include "subject.h"

using fixedpoint::Small;

IMPLEMENTATION_small(SUBJECTS)
