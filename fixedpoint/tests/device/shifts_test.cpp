// SPDX-License-Identifier: MIT
// Shifts by every count from 0 to 255, in every arithmetic.
#include <fixedpoint/arithmetic/saturating.hpp>

#include "hook.hpp"
#include "numbers.hpp"

using namespace fixedpoint;

uint8_t Hook::calls = 0;
Event Hook::event;
Operation Hook::operation;

namespace {

void check_count(const Shift& expected, uint8_t count) {
    const Number a = operand(expected.a);
    CHECK((a << count).raw() == expected.left);
    CHECK((a >> count).raw() == expected.right);
    using SaturatingNumber = Fixed<INTEGER_BITS, FRACTION_BITS, Saturating>;
    CHECK((SaturatingNumber::from_raw(a.raw()) << count).raw() == expected.saturated_left);
    CHECK((checked(expected.a) << count).raw() == expected.left);
    const bool fits =
        a.raw() == 0 || (count < RawLimits<Raw>::width && expected.left >> count == a.raw());
    CHECK(hooked(!fits, Event::overflow, Operation::shift_left));
    Number x = a;
    CHECK((x <<= count).raw() == expected.left);
    x = a;
    CHECK((x >>= count).raw() == expected.right);
}

void check_shift(const Shift& expected) {
    const uint8_t last = expected.count == RawLimits<Raw>::width ? 255 : expected.count;
    for (uint8_t count = expected.count;; ++count) {
        check_count(expected, count);
        if (count == last) break;
    }
}

}  // namespace

void test_shifts() { for_each(shifts, check_shift); }
