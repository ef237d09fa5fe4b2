/* SPDX-License-Identifier: GPL-3.0-or-later
 * Functions as strangers write them, some of them wrong. */
#include <stdint.h>

#define KEEP __attribute__((used, noinline))

/* Truncates. */
KEEP int32_t multiply(int32_t a, int32_t b) { return (int64_t)a * b >> 16; }

KEEP uint16_t average(uint16_t a, uint16_t b) { return ((uint32_t)a + b) / 2; }

KEEP int32_t my_sqrt(int32_t a) {
    uint64_t square, root = 0;
    if (a <= 0) return 0;
    square = (uint64_t)a << 16;
    for (uint32_t bit = (uint32_t)1 << 23; bit; bit >>= 1)
        if ((root | bit) * (root | bit) <= square) root |= bit;
    return root + (square - root * root > root);
}

KEEP int32_t hangs(int32_t a) {
    for (;;) __asm__ volatile("");
    return a;
}

KEEP int32_t clobbers(int32_t a) {
    __asm__ volatile("inc r9");
    return a;
}

volatile int32_t last;
KEEP int32_t strays(int32_t a) {
    last += 1;
    return a;
}

KEEP int32_t three(int32_t a, int32_t b, int16_t c) { return a + b + c; }

KEEP int16_t half(int16_t a) { return a >> 1; }

int main(void) {
    for (;;) {
    }
}
