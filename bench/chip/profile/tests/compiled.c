// SPDX-License-Identifier: GPL-3.0-or-later
// What avr-gcc makes of frames, switches, shared prologues, interrupts, recursion and long jumps.
// Each case is a program of its own, selected by CASE.
#include <avr/interrupt.h>
#include <avr/io.h>
#include <setjmp.h>
#include <stdint.h>

volatile uint8_t input = 3;
volatile int output;

__attribute__((noinline, noclone)) static void frame_of(uint8_t index) {
    volatile uint8_t bytes[100];
    bytes[index] = index;
    output += bytes[index];
}

__attribute__((noinline, noclone)) static int choose(uint8_t which) {
    switch (which) {
        case 0:
            return 17;
        case 1:
            output = 3;
            return 4711;
        case 2:
            frame_of(which);
            return 2;
        case 3:
            input = 9;
            return 90;
        case 4:
            return output;
        case 5:
            output ^= 77;
            return 333;
        case 6:
            output = input;
            return 1;
        case 7:
            return 42;
        default:
            return 0;
    }
}

__attribute__((noinline)) int quotient(int32_t a, int32_t b) { return (int)(a / b); }
__attribute__((noinline)) float ratio(float a, float b) { return a / (b + 0.5f); }
__attribute__((noinline)) int64_t product(int64_t a, int64_t b) { return a * b + 7; }

#if CASE == SIMPLE
// avr-gcc reserves a few bytes by calling the next instruction.
__attribute__((noinline, noclone)) static void small_frame_of(uint8_t index) {
    volatile uint8_t bytes[4];
    bytes[index] = index;
    output += bytes[index];
}
__attribute__((noinline, noreturn)) void stops(void) {
    for (;;) input = 1;
}
// Has no instructions after its last call: the next function follows.
__attribute__((noinline, noclone)) static void stops_within(uint8_t index) {
    volatile uint8_t bytes[20];
    bytes[index] = index;
    output += bytes[index];
    stops();
}
int main(void) {
    frame_of(input);
    small_frame_of(input);
    if (input == 200) stops_within(input);
    for (;;) output = quotient(input, 3) + (int)ratio(input, 2) + (int)product(input, 5);
}

#elif CASE == SWITCH
int main(void) {
    for (;;)
        for (uint8_t which = 0; which < 10; ++which) output += choose(which);
}

#elif CASE == RECURSION
__attribute__((noinline)) int odd(uint8_t n);
__attribute__((noinline)) int even(uint8_t n) { return n ? odd((uint8_t)(n - 1)) + 1 : 0; }
int odd(uint8_t n) { return n ? even((uint8_t)(n - 1)) + 2 : 1; }
int main(void) {
    for (;;) output = even(input);
}

#elif CASE == POINTER
static void (*volatile action)(uint8_t) = frame_of;
int main(void) {
    for (;;) action(input);
}

#elif CASE == INTERRUPTS || CASE == NESTED
ISR(TIMER1_COMPA_vect) {
#if CASE == NESTED
    sei();
#endif
    frame_of(input);
}
ISR(TIMER0_COMPA_vect) { output = quotient(output, 3); }
int main(void) {
    // Long enough that no handler is interrupted by itself.
    OCR1A = CASE == NESTED ? 4001 : 701;
    TCCR1B = 1 << WGM12 | 1 << CS10;
    TIMSK1 = 1 << OCIE1A;
    OCR0A = 113;
    TCCR0A = 1 << WGM01;
    TCCR0B = 1 << CS01;
    TIMSK0 = 1 << OCIE0A;
    sei();
    for (;;) choose(2);
}

#elif CASE == LONG_JUMP
static jmp_buf place;
__attribute__((noinline)) static void throws(uint8_t depth) {
    volatile uint8_t bytes[10];
    bytes[depth] = 1;
    output += bytes[depth];
    longjmp(place, 1);
}
__attribute__((noinline)) static void calls_throws(uint8_t depth) {
    throws(depth);
    output = 0;
}
__attribute__((noinline)) static void tries(void) {
    if (setjmp(place) == 0) calls_throws(input);
    output = 1;
}
int main(void) {
    for (;;) tries();
}
#endif
