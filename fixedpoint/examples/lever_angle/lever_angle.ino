// SPDX-License-Identifier: MIT
// The angle and the length of a lever from two readings, in fixed point: prints degrees and metres.
#include <fixedpoint.h>

using namespace fixedpoint;
using namespace fixedpoint::literals;

void setup() { Serial.begin(115200); }

void loop() {
    // Readings of 0..1023 stand for -0.5 m to 0.5 m.
    const Q16_16 x = convert<Q16_16>(analogRead(A0) - 512) / 1024.0_q16_16;
    const Q16_16 y = convert<Q16_16>(analogRead(A1) - 512) / 1024.0_q16_16;

    const Q16_16 degrees = atan2(y, x) * 57.29577951308232_q16_16;
    const Q16_16 metres = sqrt(x * x + y * y);

    char text[text_capacity<Q16_16>()];
    Serial.write(text, print(degrees, 1, text, sizeof text));
    Serial.write(" degrees, ");
    Serial.write(text, print(metres, 3, text, sizeof text));
    Serial.println(" m");
    delay(200);
}
