// SPDX-License-Identifier: MIT
// show(NAME, NUMBER) prints a line: to the standard output on the host, to the UART on the AVR.
#pragma once

#include <fixedpoint/text.hpp>

#ifdef __AVR__
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

static void put(char c) {
    while (!(UCSR0A & _BV(UDRE0))) {
    }
    UDR0 = c;
}
#else
#include <stdio.h>

static void put(char c) { putchar(c); }
#endif

static void begin() {
#ifdef __AVR__
    UCSR0B = _BV(TXEN0);
#endif
}

template <class Number>
static void show(const char* name, Number value) {
    char digits[fixedpoint::text_capacity<Number>()];
    const size_t count = fixedpoint::print(value, digits, sizeof digits);
    while (*name) put(*name++);
    put(' ');
    for (size_t i = 0; i < count; ++i) put(digits[i]);
    put('\n');
}

// Ends the simulator, which takes sleep without interrupts for the end of all things.
static void end() {
#ifdef __AVR__
    UCSR0A |= _BV(TXC0);
    put('.');
    while (!(UCSR0A & _BV(TXC0))) {
    }
    cli();
    sleep_mode();
#endif
}
