/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Test programs are functions that a test starts by name after the start-up code; they end in
   done(). What they observe they write to GPIOR0, where the test reads it with its cycle. */
#ifndef WORKAROUNDS_H
#define WORKAROUNDS_H

#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

#define TEST_PROGRAM void __attribute__((used, noinline))

TEST_PROGRAM done(void) {
    for (;;) {
    }
}
int main(void) { done(); }

static inline void mark(uint8_t value) { GPIOR0 = value; }

#endif
