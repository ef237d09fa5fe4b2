/* SPDX-License-Identifier: MIT
 * put(CHARACTER): to the standard output on the host, to the UART on the AVR, between begin() and
 * end(). */
#ifndef CONSUMER_CONSOLE_H
#define CONSUMER_CONSOLE_H

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

static void begin(void) {
#ifdef __AVR__
    UCSR0B = _BV(TXEN0);
#endif
}

/* Ends the simulator, which takes sleep without interrupts for the end of all things. */
static void end(void) {
#ifdef __AVR__
    UCSR0A |= _BV(TXC0);
    put('.');
    while (!(UCSR0A & _BV(TXC0))) {
    }
    cli();
    sleep_mode();
#endif
}

#endif
