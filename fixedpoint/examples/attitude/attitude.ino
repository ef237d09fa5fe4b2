// SPDX-License-Identifier: MIT
// The attitude of a body that rotates at a constant rate, as a quaternion that stays normalised; a
// vector rotated by it, and the same vector through the inverse of a matrix; and, separately, a
// phasor.
#include <fixedpoint.h>

#include <fixedpoint/blocks/complex.hpp>
#include <fixedpoint/blocks/matrix.hpp>
#include <fixedpoint/blocks/quaternion.hpp>

using namespace fixedpoint;
using namespace fixedpoint::literals;

// Half of a rotation by 0.02 rad about (1, 2, 2) / 3.
static const Quaternion<Q16_16> turn = {
    {0.99995_q16_16, 0.003333_q16_16, 0.006667_q16_16, 0.006667_q16_16}};
static const Complex<Q16_16> phasor_turn = {{0.9998_q16_16, 0.019999_q16_16}};
static const Matrix<Q16_16, 3> axes = {{{2_q16_16, 0.5_q16_16, 0_q16_16},
                                        {0.5_q16_16, 3_q16_16, -1_q16_16},
                                        {0_q16_16, -1_q16_16, 4_q16_16}}};

static Quaternion<Q16_16> attitude = {{1_q16_16, 0_q16_16, 0_q16_16, 0_q16_16}};
static Complex<Q16_16> phasor = {{1_q16_16, 0_q16_16}};
static Matrix<Q16_16, 3> inverse;

void setup() {
    Serial.begin(115200);
    if (!invert(axes, inverse)) Serial.println("no inverse");
}

void loop() {
    attitude = renormalised(turn * attitude);
    phasor = phasor_turn * phasor;

    const Q16_16 forward[3] = {1_q16_16, 0_q16_16, 0_q16_16};
    Q16_16 turned[3], components[3];
    rotate(attitude, forward, turned);
    multiply(inverse, turned, components);
    for (uint8_t i = 0; i < 3; ++i) {
        print(Serial, turned[i], 4);
        Serial.print(' ');
        print(Serial, components[i], 4);
        Serial.print(' ');
    }
    print(Serial, phasor.real(), 4);
    Serial.println();
    delay(20);
}
