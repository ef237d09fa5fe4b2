// SPDX-License-Identifier: MIT
// One noisy input through three filters, for the serial plotter, 500 times a second: a first-order
// low-pass filter, a second-order one, and the mean of 16 inputs; and its cube, by a polynomial.
#include <fixedpoint.h>

#include <fixedpoint/blocks/biquad.hpp>
#include <fixedpoint/blocks/moving_average.hpp>
#include <fixedpoint/blocks/one_pole.hpp>
#include <fixedpoint/blocks/polynomial.hpp>

using namespace fixedpoint;
using namespace fixedpoint::literals;

static OnePole<Q16_16> first_order(0.06_q16_16);  // 5 Hz
// Butterworth, 10 Hz at 500 Hz. In a saturating format, a large input cannot upset the filter.
using Signal = Fixed<16, 16, Saturating>;
static Biquad<Signal> second_order({convert<Signal>(0.00362168_q32_32),
                                    convert<Signal>(0.00724336_q32_32),
                                    convert<Signal>(0.00362168_q32_32),
                                    convert<Signal>(-1.82269493_q32_32),
                                    convert<Signal>(0.83718165_q32_32)});
static MovingAverage<Q16_16, 16> mean;
// x^3. With the finer format of the coefficients, only the rounding of the result matters.
using Fine = Fixed<8, 24>;
static const Table<Fine, 4> cube FIXEDPOINT_PROGRAM_MEMORY = {
    {Fine(), Fine(), Fine(), Fine::from_raw(1L << 24)}};

void setup() { Serial.begin(115200); }

void loop() {
    // -1 to 1.
    const Q16_16 x = Q16_16::from_integer(analogRead(A0) - 512) >> 9;
    print(Serial, x, 4);
    Serial.print(' ');
    print(Serial, first_order.update(x), 4);
    Serial.print(' ');
    print(Serial, second_order.update(convert<Signal>(x)), 4);
    Serial.print(' ');
    print(Serial, mean.update(x), 4);
    Serial.print(' ');
    print(Serial, polynomial(x, cube), 4);
    Serial.println();
    delay(2);
}
