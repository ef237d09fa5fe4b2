// SPDX-License-Identifier: GPL-3.0-or-later
// Products and quotients with other roundings than the default's, of every format of the library.
#include <fixedpoint/arithmetic/rounded.hpp>

#include "subject.h"

using fixedpoint::Downward;
using fixedpoint::HalfToEven;
using fixedpoint::TowardZero;

IMPLEMENTATION_toward_zero(SUBJECTS) IMPLEMENTATION_downward(SUBJECTS)
    IMPLEMENTATION_half_to_even(SUBJECTS)
