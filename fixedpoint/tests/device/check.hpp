// SPDX-License-Identifier: MIT
// Checks that count their results, for a chip that cannot print: the runner reads the counters once
// the program has reached finished().
#pragma once

#include <stdint.h>

#ifndef __AVR__
#error "These tests are for the device; the host has tests of its own."
#endif

extern "C" {
extern uint16_t checks, failures;
// The place of the first failure; the row is the index in the table being processed, from 0.
extern char first_failing_test[32];
extern uint16_t first_failing_line, first_failing_row;
void finished();
}

extern uint16_t row;

void record(bool holds, uint16_t line);

#define CHECK(condition) record((condition), __LINE__)
