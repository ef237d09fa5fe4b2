// SPDX-License-Identifier: MIT
// Checked returns what the default arithmetic returns, and reports events to its hook.
#include <fixedpoint/math.hpp>

#include "hook.hpp"
#include "numbers.hpp"

using namespace fixedpoint;

uint8_t Hook::calls = 0;
Event Hook::event;
Operation Hook::operation;

namespace {

void check_pair(const Pair& expected) {
    const auto a = checked(expected.a), b = checked(expected.b);
    const uint8_t overflows = expected.overflows;
    CHECK((a + b).raw() == expected.sum);
    CHECK(hooked(overflows & 1, Event::overflow, Operation::add));
    CHECK((a - b).raw() == expected.difference);
    CHECK(hooked(overflows & 2, Event::overflow, Operation::subtract));
    CHECK((a * b).raw() == expected.product);
    CHECK(hooked(overflows & 4, Event::overflow, Operation::multiply));
    const bool by_zero = expected.b == 0;
    CHECK((a / b).raw() == expected.quotient);
    CHECK(hooked(by_zero || (overflows & 8), by_zero ? Event::division_by_zero : Event::overflow,
                 Operation::divide));
    CHECK((a % b).raw() == expected.remainder);
    CHECK(hooked(by_zero, Event::division_by_zero, Operation::remainder));
}

void check_single(const Single& expected) {
    const auto a = checked(expected.a);
    CHECK((-a).raw() == expected.negated);
    CHECK(
        hooked(expected.negated != expected.saturated_negated, Event::overflow, Operation::negate));
    CHECK(sqrt(a).raw() == expected.sqrt);
    CHECK(hooked(expected.a < 0, Event::domain_error, Operation::sqrt));
    CHECK((convert<Fixed<8, 8, ::Checked>>(a).raw()) == expected.as_q8_8);
    CHECK(hooked(!(expected.fits & 2), Event::overflow, Operation::convert));
}

}  // namespace

void test_checked() {
    for_each(pairs, check_pair);
    for_each(singles, check_single);
}
