// SPDX-License-Identifier: GPL-3.0-or-later
// Saturating sums of which none or one operand is a constant, inlined as in a program that has one
// of them.
#include <fixedpoint.h>

#include <fixedpoint/arithmetic/saturating.hpp>

using Number = fixedpoint::Fixed<16, 16, fixedpoint::Saturating>;
constexpr Number constant = Number::from_raw(0x12345678);

#define SUBJECT extern "C" __attribute__((used, noinline, flatten)) int32_t

SUBJECT sum(int32_t a, int32_t b) { return (Number::from_raw(a) + Number::from_raw(b)).raw(); }
SUBJECT difference(int32_t a, int32_t b) {
    return (Number::from_raw(a) - Number::from_raw(b)).raw();
}
SUBJECT sum_with_constant(int32_t a) { return (Number::from_raw(a) + constant).raw(); }
SUBJECT constant_and_sum(int32_t a) { return (constant + Number::from_raw(a)).raw(); }
SUBJECT difference_from_constant(int32_t a) { return (constant - Number::from_raw(a)).raw(); }
SUBJECT difference_with_constant(int32_t a) { return (Number::from_raw(a) - constant).raw(); }

int main() {}
