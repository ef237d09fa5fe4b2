// SPDX-License-Identifier: MIT
// The operators of the default arithmetic and of the one that saturates.
#include <fixedpoint/arithmetic/saturating.hpp>

#include "numbers.hpp"

using namespace fixedpoint;

namespace {

void check_assignments(const Pair& expected) {
    const Number a = operand(expected.a), b = operand(expected.b);
    Number x = a;
    CHECK((x += b).raw() == expected.sum && x.raw() == expected.sum);
    x = a;
    CHECK((x -= b).raw() == expected.difference && x.raw() == expected.difference);
    x = a;
    CHECK((x *= b).raw() == expected.product && x.raw() == expected.product);
    x = a;
    CHECK((x /= b).raw() == expected.quotient && x.raw() == expected.quotient);
    x = a;
    CHECK((x %= b).raw() == expected.remainder && x.raw() == expected.remainder);
}

void check_pair(const Pair& expected) {
    const Number a = operand(expected.a), b = operand(expected.b);
    CHECK((a + b).raw() == expected.sum);
    CHECK((a - b).raw() == expected.difference);
    CHECK((a * b).raw() == expected.product);
    CHECK((a / b).raw() == expected.quotient);
    CHECK((a % b).raw() == expected.remainder);
    CHECK((a == b) == (expected.a == expected.b) && (a != b) == (expected.a != expected.b));
    CHECK((a < b) == (expected.a < expected.b) && (a >= b) == (expected.a >= expected.b));
    CHECK((a > b) == (expected.a > expected.b) && (a <= b) == (expected.a <= expected.b));
    check_assignments(expected);
}

Fixed<INTEGER_BITS, FRACTION_BITS, Saturating> saturating(Raw raw) {
    return Fixed<INTEGER_BITS, FRACTION_BITS, Saturating>::from_raw(operand(raw).raw());
}

void check_saturating(const Pair& expected) {
    const auto a = saturating(expected.a), b = saturating(expected.b);
    CHECK((a + b).raw() == expected.saturated_sum);
    CHECK((a - b).raw() == expected.saturated_difference);
    CHECK((a * b).raw() == expected.saturated_product);
    CHECK((a / b).raw() == expected.quotient);
    CHECK((a % b).raw() == expected.remainder);
}

void check_negative(const Single& expected) {
    CHECK((-operand(expected.a)).raw() == expected.negated);
    CHECK((+operand(expected.a)).raw() == expected.a);
    CHECK((-saturating(expected.a)).raw() == expected.saturated_negated);
}

}  // namespace

void test_operators() {
    for_each(pairs, check_pair);
    for_each(pairs, check_saturating);
    for_each(singles, check_negative);
}
