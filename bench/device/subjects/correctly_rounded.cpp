// SPDX-License-Identifier: GPL-3.0-or-later
// The functions that are correctly rounded: FUNCTIONS, which do not all fit one program.
#include <fixedpoint/arithmetic/correctly_rounded.hpp>

#include "subject.h"

using fixedpoint::CorrectlyRounded;

FUNCTIONS(SUBJECTS)
