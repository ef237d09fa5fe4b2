// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers without a sign, in all formats of the catalogue.
#include "bench/lab/catalogue/functions.hpp"
#include "subject.h"

using catalogue::Functions;
using fixedpoint::Nearest;

IMPLEMENTATION_unsigned(SUBJECTS) IMPLEMENTATION_unsigned_auxiliary(SUBJECTS)
