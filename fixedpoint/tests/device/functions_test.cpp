// SPDX-License-Identifier: MIT
// Functions of one number, order, and conversions between formats, integers and floating point.
#include <fixedpoint/math.hpp>

#include "numbers.hpp"

using namespace fixedpoint;

namespace {

void check_single(const Single& expected) {
    const Number a = operand(expected.a);
    CHECK(abs(a).raw() == expected.absolute);
    CHECK(sqrt(a).raw() == expected.sqrt);
    CHECK(floor(a).raw() == expected.floor);
    CHECK(ceil(a).raw() == expected.ceil);
    CHECK(round(a).raw() == expected.round);
    CHECK(trunc(a).raw() == expected.trunc);
}

template <class Target, class TargetRaw>
void check_format(Number a, TargetRaw wrapped, TargetRaw saturated, bool fits) {
    CHECK(NumberFormat<Target>::raw(convert<Target>(a)) == wrapped);
    const Converted<Target> result = convert_checked<Target>(a);
    CHECK(NumberFormat<Target>::raw(result.number) == saturated);
    CHECK(result.fits == fits);
}

void check_conversions(const Single& expected) {
    const Number a = operand(expected.a);
    const uint8_t fits = expected.fits;
    check_format<Q4_4>(a, expected.as_q4_4, expected.saturated_q4_4, fits & 1);
    check_format<Q8_8>(a, expected.as_q8_8, expected.saturated_q8_8, fits & 2);
    check_format<Q16_16>(a, expected.as_q16_16, expected.saturated_q16_16, fits & 4);
    check_format<Q32_32>(a, expected.as_q32_32, expected.saturated_q32_32, fits & 8);
    check_format<int16_t>(a, expected.as_int16, expected.saturated_int16, fits & 16);
}

uint32_t bits_of(float x) {
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

void check_to_float(const Single& expected) {
    CHECK(bits_of(to_float<float>(operand(expected.a))) == expected.float_bits);
    CHECK(bits_of(to_float<double>(operand(expected.a))) == expected.float_bits);
}

void check_from_float(const FromFloat& expected) {
    volatile float x;
    memcpy(const_cast<float*>(&x), &expected.bits, sizeof x);
    const Converted<Number> result = from_float_checked<Number>(static_cast<float>(x));
    CHECK(result.number.raw() == expected.number);
    CHECK(result.fits == expected.fits);
}

void check_from_decimal(const FromDecimal& expected) {
    const Converted<Number> result = from_decimal_checked<Number>(expected.n, expected.decimals);
    CHECK(result.number.raw() == expected.number);
    CHECK(result.fits == expected.fits);
}

// By hand, for cases in which a 16-bit int could be too short.
void check_integers() {
    CHECK(Q16_16::from_integer(-300).raw() == -300l * 65536);
    CHECK(convert<Q16_16>(38).raw() == 38l * 65536);
    CHECK(convert<Q32_32>(INT32_MIN).raw() == INT64_MIN);
    CHECK(convert<uint16_t>(Q16_16::from_raw(0x7fff8000)) == 0x8000);
    CHECK(convert_checked<uint8_t>(Q16_16::from_integer(-1)).number == 0);
    CHECK(from_decimal<Q16_16>(38, 2).raw() == 24904);  // 24903.68
    CHECK(from_decimal<Q4_4>(int8_t(-15), 1).raw() == -24);
    CHECK(from_decimal<Q32_32>(int64_t(314159265358979), 14).raw() == 13493037705);
}

void check_order(const Pair& expected) {
    const Number a = operand(expected.a), b = operand(expected.b), zero;
    const Number smaller = expected.a < expected.b ? a : b,
                 larger = expected.a < expected.b ? b : a;
    CHECK(min(a, b) == smaller && max(a, b) == larger);
    CHECK(clamp(a, zero, b) == (expected.b < 0 || expected.a < 0 ? zero : smaller));
}

}  // namespace

void test_functions() {
    for_each(singles, check_single);
    for_each(singles, check_conversions);
    for_each(singles, check_to_float);
    for_each(from_floats, check_from_float);
    for_each(from_decimals, check_from_decimal);
    for_each(pairs, check_order);
    check_integers();
}
