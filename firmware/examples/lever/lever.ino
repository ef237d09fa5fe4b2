// SPDX-License-Identifier: MIT
// The haptic lever: wire it as README.md of this library says, open a terminal at 250000 baud.
//
// Board drives Timer1, the converter, the serial port and pins 2, 3 and 7 itself: no Serial,
// analogRead() or Servo beside it. millis(), delay() and the other pins are Arduino's as ever, and
// loop() may do more, of half a millisecond at most.
#include <firmware.h>

using Board = firmware::Atmega328p<firmware::LeverWiring>;
using Lever = firmware::LeverProgram<Board, firmware::LeverChoices<firmware::LeverScalar>>;

FIRMWARE_INTERRUPTS(Board)

void setup() { Lever::start(); }

void loop() { Lever::pass(); }
