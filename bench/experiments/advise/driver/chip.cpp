// SPDX-License-Identifier: GPL-3.0-or-later
// The user's program for the chip: in INTEGER_BITS and FRACTION_BITS, or in float if they are not
// defined. PARAMETERS and ARGUMENTS depend on the number of inputs: "Raw a, Raw b" and "number(a),
// number(b)".
#include <fixedpoint.h>

#include "bench/experiments/advise/driver/program.hpp"

#ifdef INTEGER_BITS
using Number = fixedpoint::Fixed<INTEGER_BITS, FRACTION_BITS>;
using Raw = Number::Raw;
static Number number(Raw raw) { return Number::from_raw(raw); }
static Raw raw_of(Number x) { return x.raw(); }
#else
using Number = float;
using Raw = float;
static float number(float x) { return x; }
static float raw_of(float x) { return x; }
#endif

static Program<Number> program;

extern "C" Raw advise_step(PARAMETERS) { return raw_of(program.step(ARGUMENTS)); }

int main() {
    for (;;) {
    }
}
