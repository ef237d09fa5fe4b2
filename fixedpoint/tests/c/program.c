/* SPDX-License-Identifier: MIT
 * Calls every function of fixedpoint_c.h in one FORMAT, with boundary and random operands, and
 * leaves a hash of each function's results: the same on the host and on the chip. There, only one
 * PART of the functions fits. */
#include "program.h"

#include <fixedpoint/c_functions.h>
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

#define CALL_unary(function)                           \
    begin(#function);                                  \
    FOR_EACH {                                         \
        const number result = F(function)(operand[i]); \
        add(&result, sizeof result);                   \
    }
#define CALL_binary(function)                                       \
    begin(#function);                                               \
    FOR_EACH_PAIR {                                                 \
        const number result = F(function)(operand[i], operand[j]);  \
        const number swapped = F(function)(operand[j], operand[i]); \
        add(&result, sizeof result);                                \
        add(&swapped, sizeof swapped);                              \
    }
#define CALL_pair(function)            \
    begin(#function);                  \
    FOR_EACH {                         \
        number both[2];                \
        F(function)(operand[i], both); \
        add(both, sizeof both);        \
    }
#define CALL_binary_pair(function)                 \
    begin(#function);                              \
    FOR_EACH_PAIR {                                \
        number both[2];                            \
        F(function)(operand[i], operand[j], both); \
        add(both, sizeof both);                    \
    }
#define CALL_shift(function)                                                     \
    begin(#function);                                                            \
    FOR_EACH for (uint8_t count = 0; count < 70; count = (uint8_t)(count + 3)) { \
        const number result = F(function)(operand[i], count);                    \
        add(&result, sizeof result);                                             \
    }
#define CALL_dot(function)                                                                  \
    begin(#function);                                                                       \
    for (uint8_t i = 0; i + 3 < operands; ++i) {                                            \
        const number result = F(function)(operand + i, operand + (5 * i) % (operands - 3)); \
        add(&result, sizeof result);                                                        \
    }
#define CALL_length(function)                           \
    begin(#function);                                   \
    for (uint8_t i = 0; i + 3 < operands; ++i) {        \
        const number result = F(function)(operand + i); \
        add(&result, sizeof result);                    \
    }
#define CALL_ternary(function)                                                                \
    begin(#function);                                                                         \
    FOR_EACH_PAIR {                                                                           \
        const number result = F(function)(operand[i], operand[j], operand[operands - 1 - i]); \
        add(&result, sizeof result);                                                          \
    }
#define CALL_direction(function)                 \
    begin(#function);                            \
    for (uint8_t i = 0; i + 3 < operands; ++i) { \
        number unit[3];                          \
        F(function)(operand + i, unit);          \
        add(unit, sizeof unit);                  \
    }
#define CALL_power(function)                                                 \
    begin(#function);                                                        \
    FOR_EACH {                                                               \
        const number result = F(function)(operand[i], (int32_t)(i % 9) - 4); \
        add(&result, sizeof result);                                         \
    }
#define CALL_direct_pair CALL_pair
#define CALL_negation CALL_unary
#define CALL_operator CALL_binary
#define CALL_sign CALL_unary
#define CALL_integer CALL_unary

#define CONVERSION(type, to, from)         \
    begin(#from);                          \
    FOR_EACH {                             \
        const type other = to(operand[i]); \
        const number result = from(other); \
        add(&other, sizeof other);         \
        add(&result, sizeof result);       \
    }
#define THROUGH(other, ...) CONVERSION(other, JOIN(other##_from, FORMAT), JOIN(F(from), other))

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

static void test_conversions(void) {
    const float zero = (float)strlen("");
    const float special[] = {zero / zero, 1e30f, -1e30f, 1e-30f};
    CONVERSION(int32_t, F(to_int32), F(from_int32))
    CONVERSION(float, F(to_float), F(from_float))
    begin("from_float out of range");
    for (uint8_t i = 0; i < 4; ++i) {
        const number result = F(from_float)(special[i]);
        add(&result, sizeof result);
    }
    JOIN(FIXEDPOINT_C_BESIDE, FORMAT)(THROUGH, ) test_text();
}

/* The functions in their order, in parts of equal numbers; the last part is the conversions. */
#define INDEX(name, shape, ...) index_##name,
enum { FIXEDPOINT_C_FUNCTIONS(INDEX, ) functions };
#define CALL(name, shape, ...)                              \
    if (index_##name * (C_PARTS - 1) / functions == part) { \
        CALL_##shape(name)                                  \
    }
static inline void run(uint8_t part) {
    F(results).count = 0;
    make_operands();
    FIXEDPOINT_C_FUNCTIONS(CALL, )
    if (part == C_PARTS - 1) test_conversions();
}

#ifdef PART
__attribute__((noinline, used)) void finished(void) {
    for (;;) {
    }
}

int main(void) {
    run(PART);
    finished();
}
#else
void F(run)(uint8_t part) { run(part); }
#endif
