// SPDX-License-Identifier: GPL-3.0-or-later
// The operations on float that the engine uses, as the compiler and avr-libc implement them on the
// chip.
#include <math.h>
#include <stdint.h>

#define FROM_OUTSIDE extern "C" __attribute__((noinline))

FROM_OUTSIDE float add(float a, float b) { return a + b; }
FROM_OUTSIDE float subtract(float a, float b) { return a - b; }
FROM_OUTSIDE float multiply(float a, float b) { return a * b; }
FROM_OUTSIDE float divide(float a, float b) { return a / b; }
FROM_OUTSIDE float square_root(float a) { return sqrtf(a); }
FROM_OUTSIDE uint8_t less(float a, float b) { return a < b; }
FROM_OUTSIDE uint8_t equal(float a, float b) { return a == b; }

volatile float told;

int main() {
    for (;;) {
        const float a = told, b = told;
        told = add(a, b) + subtract(a, b) + multiply(a, b) + divide(a, b) + square_root(a) +
               less(a, b) + equal(a, b);
    }
}
