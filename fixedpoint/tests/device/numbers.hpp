// SPDX-License-Identifier: MIT
// The format under test, INTEGER_BITS and FRACTION_BITS, and the rows of expected results that
// expected.py computes for it, in program memory.
#pragma once

#include <avr/pgmspace.h>
#include <string.h>

#include <fixedpoint/conversion.hpp>
#include <fixedpoint/fixed.hpp>
#include <fixedpoint/text.hpp>

#include "check.hpp"

using Number = fixedpoint::Fixed<INTEGER_BITS, FRACTION_BITS>;
using Raw = Number::Raw;

struct Pair {
    Raw a, b;
    Raw sum, difference, product, quotient, remainder;
    Raw saturated_sum, saturated_difference, saturated_product;
    // Whether sum, difference, product and quotient, rounded, are out of range: bits 0 to 3.
    uint8_t overflows;
};
struct WithInteger {
    Raw a;
    int32_t n;
    // a + n, a - n, n - a, a n.
    Raw wrapped[4], saturated[4];
    Raw quotient;
    int8_t comparison;  // the sign of a - n
};
struct SmallOperations {
    Raw a, b, t;
    Raw lerp, saturated_lerp, midpoint, abs_diff, copysign, smoothstep;
    Raw quotient, remainder, floored_quotient, floored_remainder;
    int8_t sign;
};
struct Shift {
    Raw a;
    uint8_t count;  // in the last row for an `a`, it also stands for all larger counts
    Raw left, saturated_left, right;
};
struct Single {
    Raw a;
    Raw negated, saturated_negated, absolute, sqrt, floor, ceil, round, trunc;
    int8_t as_q4_4, saturated_q4_4;
    int16_t as_q8_8, saturated_q8_8;
    int32_t as_q16_16, saturated_q16_16;
    int64_t as_q32_32, saturated_q32_32;
    int16_t as_int16, saturated_int16;
    uint8_t fits;  // into q4_4, q8_8, q16_16, q32_32, int16: bits 0 to 4
    uint32_t float_bits;
};
struct FromFloat {
    uint32_t bits;
    Raw number;
    bool fits;
};
struct FromDecimal {
    int32_t n;
    uint8_t decimals;
    Raw number;
    bool fits;
};
struct Parse {
    char text[60];
    Raw number;
    fixedpoint::TextStatus status;
    uint8_t position;
};
struct Print {
    Raw number;
    int8_t decimals;  // -1: the shortest that reads back
    char text[40];
};

template <class Row>
struct Rows {
    const Row* first;
    uint16_t count;
};
extern const Rows<Pair> pairs;
extern const Rows<WithInteger> with_integers;
extern const Rows<SmallOperations> small_operations;
extern const Rows<Shift> shifts;
extern const Rows<Single> singles;
extern const Rows<FromFloat> from_floats;
extern const Rows<FromDecimal> from_decimals;
extern const Rows<Parse> parses;
extern const Rows<Print> prints;

template <class Row, class Check>
void for_each(const Rows<Row>& rows, Check check) {
    for (row = 0; row < rows.count; ++row) {
        Row expected;
        memcpy_P(&expected, rows.first + row, sizeof expected);
        check(expected);
    }
    row = 0;
}

// A number that is unknown to the compiler.
__attribute__((noinline)) inline Number operand(Raw raw) {
    volatile Raw hidden = raw;
    return Number::from_raw(hidden);
}
