// SPDX-License-Identifier: MIT
// The angle and the length of a lever from two readings, in fixed point: prints degrees and metres.
#include <fixedpoint.h>

using namespace fixedpoint;
using namespace fixedpoint::literals;

void setup() { Serial.begin(115200); }

void loop() {
    // Readings of 0..1023 represent -0.5 m to 0.5 m.
    const Q16_16 x = convert<Q16_16>(analogRead(A0) - 512) / 1024.0_q16_16;
    const Q16_16 y = convert<Q16_16>(analogRead(A1) - 512) / 1024.0_q16_16;

    const Q16_16 degrees = atan2(y, x) * 57.29577951308232_q16_16;
    const Q16_16 metres = sqrt(x * x + y * y);

    print(Serial, degrees, 1);
    Serial.print(" degrees, ");
    print(Serial, metres, 3);
    Serial.println(" m");
    delay(200);
}
