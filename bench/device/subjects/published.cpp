// SPDX-License-Identifier: GPL-3.0-or-later
// The arithmetic of the 2016 design, the baseline.
#include <fixedpoint/arithmetic/published.hpp>

#include "subject.h"

using fixedpoint::Published;

IMPLEMENTATION_published(SUBJECTS)
