// SPDX-License-Identifier: GPL-3.0-or-later
// The functions that are the exact result, rounded: FUNCTIONS, of which not all fit one program.
#include <fixedpoint/arithmetic/correctly_rounded.hpp>

#include "subject.h"

using fixedpoint::CorrectlyRounded;

FUNCTIONS(SUBJECTS)
