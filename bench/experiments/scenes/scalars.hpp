// SPDX-License-Identifier: GPL-3.0-or-later
// The scalars that scenes run with, on the chip and on the host, under their names in programs and
// data files. `float` is the compiler's.
#pragma once

#include <fixedpoint/arithmetic/published.hpp>
#include <fixedpoint/arithmetic/saturating.hpp>
#include <fixedpoint/fixed.hpp>

namespace scalars {

using q8_8 = fixedpoint::Q8_8;
using q8_24 = fixedpoint::Fixed<8, 24>;
using q16_16 = fixedpoint::Q16_16;
using q32_32 = fixedpoint::Q32_32;
using q16_16_saturating = fixedpoint::Fixed<16, 16, fixedpoint::Saturating>;
using q16_16_published = fixedpoint::Fixed<16, 16, fixedpoint::Published>;

}  // namespace scalars
