// SPDX-License-Identifier: GPL-3.0-or-later
// Angles in turns and degrees, and operations that are exact or rounded once, in one format of the
// library, LIBRARY_FORMAT.
#include "bench/lab/catalogue/functions.hpp"
#include "subject.h"

using catalogue::Functions;

IMPLEMENTATION_auxiliary(SUBJECTS_IN_FORMAT)
