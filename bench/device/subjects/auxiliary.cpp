// SPDX-License-Identifier: GPL-3.0-or-later
// Angles in turns and degrees, and what is exact or rounded once, of one format of the library,
// LIBRARY_FORMAT.
#include "bench/lab/catalogue/functions.hpp"
#include "subject.h"

using catalogue::Functions;

IMPLEMENTATION_auxiliary(SUBJECTS_IN_FORMAT)
