// SPDX-License-Identifier: MIT
// The haptic lever: wire it as described in README.md of this library, and open a terminal at
// 250000 baud.
//
// Board drives Timer1, the converter, the serial port and pins 2, 3 and 7 itself, so Serial,
// analogRead() and Servo cannot be used. millis(), delay() and the other pins are Arduino's as
// usual, and loop() may do more work, of at most half a millisecond.
#include <firmware.h>

using Board = firmware::Atmega328p<firmware::LeverWiring>;
using Lever = firmware::LeverProgram<Board, firmware::LeverChoices<firmware::LeverScalar>>;

FIRMWARE_INTERRUPTS(Board)

void setup() { Lever::start(); }

void loop() { Lever::pass(); }
