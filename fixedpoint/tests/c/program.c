/* SPDX-License-Identifier: MIT
 * Calls every function of fixedpoint_c.h in one FORMAT, with boundary and random operands, and
 * leaves a hash of each function's results: the same on the host and on the chip. There, a PART of
 * the functions fits: operations, functions, angles, turns, powers, auxiliary or conversions. */
#include "program.h"

#include <fixedpoint_c.h>
#include <string.h>

#define JOINED(format, name) format##_##name
#define JOIN(format, name) JOINED(format, name)
#define F(name) JOIN(FORMAT, name)

typedef FORMAT number;

/* The first 12 are boundaries, of which all pairs are taken. */
enum { boundaries = 12, operands = 40 };
static number operand[operands];

struct c_results F(results);

static void make_operands(void) {
    const uint8_t width = 8 * sizeof(number);
    const number min = (number)(UINT64_C(1) << (width - 1)), max = (number)~min;
    const number one = F(from_int32)(1);
    const number boundary[boundaries] = {0,
                                         1,
                                         -1,
                                         min,
                                         max,
                                         (number)(min + 1),
                                         (number)(max - 1),
                                         one,
                                         (number)-one,
                                         (number)(one + 1),
                                         (number)(one / 2),
                                         (number)(3 * one)};
    uint64_t random = UINT64_C(88172645463325252);
    memcpy(operand, boundary, sizeof boundary);
    for (uint8_t i = boundaries; i < operands; ++i) {
        random ^= random << 13;
        random ^= random >> 7;
        random ^= random << 17;
        operand[i] = F(shift_right)((number)random, i % width);
    }
}

static void begin(const char* name) {
    uint32_t* const hash = &F(results).hash[F(results).count];
    *hash = UINT32_C(2166136261);
#ifdef __AVR__
    (void)name;
#else
    F(results).name[F(results).count] = name;
#endif
    ++F(results).count;
}

/* FNV-1a. */
static void add(const void* bytes, size_t size) {
    uint32_t* const hash = &F(results).hash[F(results).count - 1];
    for (size_t i = 0; i < size; ++i) {
        *hash = (*hash ^ ((const uint8_t*)bytes)[i]) * UINT32_C(16777619);
    }
}

#define FOR_EACH for (uint8_t i = 0; i < operands; ++i)
#define FOR_EACH_PAIR                      \
    for (uint8_t i = 0; i < operands; ++i) \
        for (uint8_t j = i % boundaries; j < boundaries; ++j)

#define UNARY(function)                                \
    begin(#function);                                  \
    FOR_EACH {                                         \
        const number result = F(function)(operand[i]); \
        add(&result, sizeof result);                   \
    }
#define BINARY(function)                                            \
    begin(#function);                                               \
    FOR_EACH_PAIR {                                                 \
        const number result = F(function)(operand[i], operand[j]);  \
        const number swapped = F(function)(operand[j], operand[i]); \
        add(&result, sizeof result);                                \
        add(&swapped, sizeof swapped);                              \
    }
#define TWO_OF_UNARY(function)         \
    begin(#function);                  \
    FOR_EACH {                         \
        number both[2];                \
        F(function)(operand[i], both); \
        add(both, sizeof both);        \
    }
#define TWO_OF_BINARY(function)                    \
    begin(#function);                              \
    FOR_EACH_PAIR {                                \
        number both[2];                            \
        F(function)(operand[i], operand[j], both); \
        add(both, sizeof both);                    \
    }
#define SHIFT(function)                                                          \
    begin(#function);                                                            \
    FOR_EACH for (uint8_t count = 0; count < 70; count = (uint8_t)(count + 3)) { \
        const number result = F(function)(operand[i], count);                    \
        add(&result, sizeof result);                                             \
    }
#define OF_VECTORS(function)                                                                \
    begin(#function);                                                                       \
    for (uint8_t i = 0; i + 3 < operands; ++i) {                                            \
        const number result = F(function)(operand + i, operand + (5 * i) % (operands - 3)); \
        add(&result, sizeof result);                                                        \
    }
#define OF_VECTOR(function)                             \
    begin(#function);                                   \
    for (uint8_t i = 0; i + 3 < operands; ++i) {        \
        const number result = F(function)(operand + i); \
        add(&result, sizeof result);                    \
    }
#define CONVERSION(type, to, from)         \
    begin(#from);                          \
    FOR_EACH {                             \
        const type other = to(operand[i]); \
        const number result = from(other); \
        add(&other, sizeof other);         \
        add(&result, sizeof result);       \
    }
/* Through another format; FORMAT itself has no conversion to itself. */
#define THROUGH(other) CONVERSION(other, JOIN(other##_from, FORMAT), JOIN(F(from), other))

static void test_text(void) {
    static const char* const texts[] = {"", "-", "1x", "1e9", "-1e9", "-0.5", ".5", "5.", "+15e-1"};
    char text[100];
    begin("print and parse");
    FOR_EACH {
        number read;
        const size_t length = F(print)(operand[i], text, sizeof text);
        const fixedpoint_text_status status = F(parse)(text, &read);
        add(text, length + 1);
        add(&status, 1);
        add(&read, sizeof read);
        add(text, F(print_decimals)(operand[i], i, text, sizeof text));
        add(text, F(print)(operand[i], text, i % 8));
    }
    for (uint8_t i = 0; i < sizeof texts / sizeof *texts; ++i) {
        number read;
        const fixedpoint_text_status status = F(parse)(texts[i], &read);
        add(&status, 1);
        add(&read, sizeof read);
    }
}

static void start(void) {
    F(results).count = 0;
    make_operands();
}

void F(operations)(void) {
    start();
    BINARY(add)
    BINARY(subtract)
    BINARY(multiply)
    BINARY(divide)
    BINARY(remainder)
    UNARY(negate)
    UNARY(abs)
    UNARY(sqrt)
    SHIFT(shift_left)
    SHIFT(shift_right)
    OF_VECTORS(dot2)
    OF_VECTORS(dot3)
    OF_VECTOR(length2)
    OF_VECTOR(length3)
    begin("multiply_add");
    FOR_EACH_PAIR {
        const number result = F(multiply_add)(operand[i], operand[j], operand[operands - 1 - i]);
        add(&result, sizeof result);
    }
    begin("normalise3");
    for (uint8_t i = 0; i + 3 < operands; ++i) {
        number unit[3];
        F(normalise3)(operand + i, unit);
        add(unit, sizeof unit);
    }
}

void F(functions)(void) {
    start();
    BINARY(atan2)
    UNARY(reciprocal_sqrt)
    UNARY(sin)
    UNARY(cos)
    UNARY(atan)
    UNARY(exp)
    UNARY(log)
    TWO_OF_UNARY(sincos)
}

void F(angles)(void) {
    start();
    UNARY(tan)
    UNARY(asin)
    UNARY(acos)
}

void F(powers)(void) {
    start();
    UNARY(exp2)
    UNARY(expm1)
    UNARY(log2)
    UNARY(log10)
    UNARY(log1p)
    UNARY(sinh)
    UNARY(cosh)
    UNARY(tanh)
    UNARY(cbrt)
    begin("pow");
    FOR_EACH {
        const number result = F(pow)(operand[i], operand[(7 * i + 5) % operands]);
        add(&result, sizeof result);
    }
}

void F(turns)(void) {
    start();
    UNARY(sin_turns)
    UNARY(cos_turns)
    TWO_OF_UNARY(sincos_turns)
    BINARY(atan2_turns)
    UNARY(sin_degrees)
    UNARY(cos_degrees)
    TWO_OF_UNARY(sincos_degrees)
    BINARY(atan2_degrees)
}

void F(auxiliary)(void) {
    start();
    TWO_OF_BINARY(divrem)
    TWO_OF_BINARY(divmod)
    BINARY(midpoint)
    BINARY(abs_diff)
    BINARY(copysign)
    UNARY(smoothstep)
    UNARY(sign)
    UNARY(isqrt)
    begin("lerp");
    FOR_EACH_PAIR {
        const number result = F(lerp)(operand[i], operand[j], operand[operands - 1 - i]);
        add(&result, sizeof result);
    }
    begin("power");
    FOR_EACH {
        const number result = F(power)(operand[i], (int32_t)(i % 9) - 4);
        add(&result, sizeof result);
    }
}

void F(conversions)(void) {
    const float zero = (float)strlen("");
    const float special[] = {zero / zero, 1e30f, -1e30f, 1e-30f};
    start();
    CONVERSION(int32_t, F(to_int32), F(from_int32))
    CONVERSION(float, F(to_float), F(from_float))
    begin("from_float out of range");
    for (uint8_t i = 0; i < 4; ++i) {
        const number result = F(from_float)(special[i]);
        add(&result, sizeof result);
    }
#ifndef IS_q4_4
    THROUGH(q4_4)
#endif
#ifndef IS_q8_8
    THROUGH(q8_8)
#endif
#ifndef IS_q16_16
    THROUGH(q16_16)
#endif
#ifndef IS_q8_24
    THROUGH(q8_24)
#endif
#ifndef IS_q32_32
    THROUGH(q32_32)
#endif
    test_text();
}

#ifdef __AVR__
__attribute__((noinline, used)) void finished(void) {
    for (;;) {
    }
}

int main(void) {
    F(PART)();
    finished();
}
#endif
