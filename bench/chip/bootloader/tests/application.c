/* SPDX-License-Identifier: GPL-3.0-or-later
   A program of many pages that says, once it runs, what its flash holds. */
#include <avr/io.h>
#include <avr/pgmspace.h>
#include <stdint.h>

/* All values of a byte, a page that looks erased, and an end within a page. */
#define ROW(n) n, n + 1, n + 2, n + 3, n + 4, n + 5, n + 6, n + 7
#define ROWS(n) \
    ROW(n), ROW(n + 8), ROW(n + 16), ROW(n + 24), ROW(n + 32), ROW(n + 40), ROW(n + 48), ROW(n + 56)
const uint8_t table[5001] PROGMEM = {
    ROWS(0),      ROWS(64), ROWS(128), ROWS(192), [512 ... 1023] = 0xff, [1024 ... 4999] = 0x5a,
    [5000] = 0xa5};

/* Comes to RAM from the flash behind the code. */
static volatile char greeting[] = "application ";

static void send(uint8_t byte) {
    while (!(UCSR0A & _BV(UDRE0)))
        ;
    UDR0 = byte;
}

int main(void) {
    uint16_t sum = 0;
    for (uint16_t i = 0; i < sizeof table; ++i)
        sum = (sum << 1 | sum >> 15) + pgm_read_byte(&table[i]);

    UBRR0 = 3; /* 250000 baud */
    UCSR0A = 0;
    UCSR0B = _BV(TXEN0);
    UCSR0C = _BV(UCSZ01) | _BV(UCSZ00);
    for (const volatile char* c = greeting; *c; ++c) send(*c);
    for (int8_t shift = 12; shift >= 0; shift -= 4) send("0123456789abcdef"[sum >> shift & 15]);
    send('\n');
    for (;;)
        ;
}
