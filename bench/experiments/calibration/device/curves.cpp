// SPDX-License-Identifier: GPL-3.0-or-later
// Every family of calibration curves with its coefficients in RAM, which costs a cycle per byte
// more than the firmware's constants, and the firmware's own curve.
#include <firmware/calibration.hpp>

#include "pieces_capacity.hpp"

using namespace firmware::calibration;
using fixedpoint::Q16_16;

#define CURVE(symbol, Family)                                                               \
    extern "C" int32_t symbol##_q16_16_default(const Held<Family>* held, int16_t reading) { \
        return held->grams<Q16_16>(reading).raw();                                          \
    }

CURVE(line, Line)
CURVE(rational_quadratic, RationalQuadratic)
CURVE(quadratic, Quadratic)
CURVE(hyperbola, Hyperbola)
CURVE(conductance_power, ConductancePower)

extern "C" int32_t monotone_cubic_q16_16_default(const CubicPiece* pieces, int16_t count,
                                                 int16_t lowest, int16_t highest, int16_t reading) {
    return Held<MonotoneCubic>{lowest, highest, {pieces, count}}.grams<Q16_16>(reading).raw();
}
// The bench writes the pieces here. They do not belong to the footprint of the curve, but to a
// subject of their own, which keeps them in the program.
extern "C" const CubicPiece pieces_of_monotone_cubic[pieces_capacity] FIXEDPOINT_PROGRAM_MEMORY = {
    {1, 1, 0, 0, 0, 0}};
extern "C" const CubicPiece* pieces_q16_16_default() { return pieces_of_monotone_cubic; }

extern "C" int32_t grams_q16_16_default(int16_t reading) {
    return firmware::grams<Q16_16>(reading).raw();
}
