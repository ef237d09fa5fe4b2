// SPDX-License-Identifier: GPL-3.0-or-later
// A program that uses every function of angles, in the fast variant.
#include <fixedpoint/math.hpp>

volatile int32_t raw;

int main() {
    using fixedpoint::Q16_16;
    const auto operand = [] { return Q16_16::from_raw(raw); };
    raw = sin(operand()).raw();
    raw = cos(operand()).raw();
    int32_t sine_and_cosine[2];
    fixedpoint::Nearest::sincos<int32_t, 16>(raw, sine_and_cosine);
    raw = sine_and_cosine[0];
    raw = sine_and_cosine[1];
    raw = atan(operand()).raw();
    raw = atan2(operand(), operand()).raw();
}
