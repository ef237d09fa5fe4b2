// SPDX-License-Identifier: MIT
// Checks that count themselves, for a chip that has nowhere to print: whoever runs the program
// reads the counters once it has reached finished().
#pragma once

#include <stdint.h>

#ifndef __AVR__
#error "These tests are for the device; the host has tests of its own."
#endif

extern "C" {
extern uint16_t checks, failures;
// Where the first failure was; the row is that of the table gone through, from 0.
extern char first_failing_test[32];
extern uint16_t first_failing_line, first_failing_row;
void finished();
}

extern uint16_t row;

void record(bool holds, uint16_t line);

#define CHECK(condition) record((condition), __LINE__)
