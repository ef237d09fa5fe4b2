// SPDX-License-Identifier: MIT
// Reads a number from the serial monitor, and prints it and its root in three ways: to the last
// bit, with a given number of decimals, and as a Printable.
#include <fixedpoint.h>

using namespace fixedpoint;

void setup() {
    Serial.begin(115200);
    Serial.setTimeout(50);
}

void loop() {
    if (!Serial.available()) return;
    delay(20);  // the rest of the line
    const Parsed<Q16_16> typed = read<Q16_16>(Serial);
    while (Serial.read() >= 0) {
    }
    if (typed.status != TextStatus::ok) {
        Serial.println("a number between -32768 and 32767.99998, please");
        return;
    }
    print(Serial, typed.number);
    Serial.print(" has the root ");
    print(Serial, sqrt(typed.number), 3);
    Serial.print(" or, to the last bit, ");
    Serial.println(printable(sqrt(typed.number)));
}
