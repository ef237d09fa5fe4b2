// SPDX-License-Identifier: GPL-3.0-or-later
// The scalars that scenes run with, on the chip and on the host, under their names in programs and
// data files. `float` is the compiler's.
#pragma once

#include <fixedpoint/arithmetic/published.hpp>
#include <fixedpoint/arithmetic/saturating.hpp>
#include <fixedpoint/fixed.hpp>

#include "bench/lab/catalogue/formats.h"

namespace scalars {

#define FORMAT_TYPE(name, I, F) using name = fixedpoint::Fixed<I, F>;
SCENE_FORMATS(FORMAT_TYPE)
#undef FORMAT_TYPE
using q16_16_saturating = fixedpoint::Fixed<16, 16, fixedpoint::Saturating>;
using q16_16_published = fixedpoint::Fixed<16, 16, fixedpoint::Published>;

}  // namespace scalars
