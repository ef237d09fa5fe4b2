// SPDX-License-Identifier: GPL-3.0-or-later
// The scalars that scenes run with, on the chip and on the host, under their names in programs and
// data files. `float` is the compiler's.
#pragma once

#include <fixedpoint/arithmetic/published.hpp>
#include <fixedpoint/arithmetic/saturating.hpp>
#include <fixedpoint/fixed.hpp>

// X(name, integer bits, fraction bits): the formats in which each scene runs with every method.
// CMakeLists.txt reads these lines.
// clang-format off
#define SCENE_FORMATS(X) \
    X(q8_8, 8, 8)        \
    X(q8_24, 8, 24)      \
    X(q16_16, 16, 16)    \
    X(q32_32, 32, 32)
// clang-format on

namespace scalars {

#define FORMAT_TYPE(name, I, F) using name = fixedpoint::Fixed<I, F>;
SCENE_FORMATS(FORMAT_TYPE)
#undef FORMAT_TYPE
using q16_16_saturating = fixedpoint::Fixed<16, 16, fixedpoint::Saturating>;
using q16_16_published = fixedpoint::Fixed<16, 16, fixedpoint::Published>;

}  // namespace scalars
