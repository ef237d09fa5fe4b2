// SPDX-License-Identifier: GPL-3.0-or-later
// Functions of every width and number of operands, called by device_function_test.cpp and
// avr8js_test.cpp.
#include <math.h>
#include <stdint.h>

int8_t negate_int8(int8_t a) { return -a; }
int16_t subtract_int16(int16_t a, int16_t b) { return a - b; }
int32_t multiply_int32(int32_t a, int32_t b) { return a * b; }
int32_t divide_int32(int32_t a, int32_t b) { return a / b; }
int64_t subtract_int64(int64_t a, int64_t b) { return a - b; }
float multiply_float(float a, float b) { return a * b; }
float divide_float(float a, float b) { return a / b; }

float square_root_float(float a) { return sqrtf(a); }
float arc_tangent_float(float a) { return atanf(a); }

// Bit by bit; the time depends on the operand.
uint16_t square_root_uint32(uint32_t a) {
    uint16_t root = 0;
    for (uint16_t bit = 0x8000; bit; bit >>= 1) {
        const uint16_t larger = root | bit;
        if ((uint32_t)larger * larger <= a) root = larger;
    }
    return root;
}

// The third operand is passed on the stack.
int64_t weigh_int64(int64_t a, int64_t b, int64_t c) { return a + 2 * b + 3 * c; }

// r24, r23:r22, r21..r18, r17..r10, r8, and the last three on the stack, 2 + 1 + 4 bytes.
int32_t weigh_mixed(int8_t a, int16_t b, int32_t c, int64_t d, int8_t e, int16_t f, int8_t g,
                    int32_t h) {
    return a + 3 * (int32_t)b + 5 * c + 7 * (int32_t)d + 11 * e + 13 * (int32_t)f + 17 * g + 19 * h;
}

int32_t dot3(const int32_t* a, const int32_t* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
void reverse3(const int16_t* from, int16_t* to) {
    for (uint8_t i = 0; i < 3; ++i) to[i] = from[2 - i];
}

uint16_t scale = 1000;  // initialised by the start-up code
uint16_t scaled(uint16_t a) { return a * scale; }

int main(void) { return 0; }
