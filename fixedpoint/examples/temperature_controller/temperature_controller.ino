// SPDX-License-Identifier: MIT
// Keeps a heater at 60 degrees: the temperature is interpolated in a table of the thermistor, its
// noise is averaged, and a PID controller sets the duty cycle. Prints temperature and duty ten
// times a second.
#include <fixedpoint.h>

#include <fixedpoint/blocks/interpolation.hpp>
#include <fixedpoint/blocks/moving_average.hpp>
#include <fixedpoint/blocks/pid.hpp>

using namespace fixedpoint;
using namespace fixedpoint::literals;

const uint8_t thermistor = A0, heater = 9;

// Degrees at the readings 0, 128, 256 ... 1024, for a 10 kOhm thermistor below a 10 kOhm resistor.
static const Table<Q16_16, 9> degrees FIXEDPOINT_PROGRAM_MEMORY = {
    {150_q16_16, 81.3_q16_16, 54.1_q16_16, 37.9_q16_16, 25_q16_16, 12.7_q16_16, -1_q16_16,
     -20.5_q16_16, -40_q16_16}};

static MovingAverage<Q16_16, 16> average(25_q16_16);
// For a duty cycle from 0 to 1, in steps of 100 ms: 0.05 per degree, 0.002 per degree and second,
// 0.2 per degree per second.
static Pid<Q16_16> controller({0.05_q16_16, 0.0002_q16_16, 2_q16_16}, 0_q16_16, 1_q16_16);

void setup() { Serial.begin(115200); }

void loop() {
    const Q16_16 reading = Q16_16::from_integer(analogRead(thermistor));
    const Q16_16 temperature = average.update(interpolate<7>(degrees, 0_q16_16, reading));
    const Q16_16 duty = controller.update(60_q16_16, temperature);
    analogWrite(heater, convert<int>(duty * 255_q16_16));

    print(Serial, temperature, 1);
    Serial.print(" degrees, duty ");
    print(Serial, duty, 3);
    Serial.println();
    delay(100);
}
