// SPDX-License-Identifier: MIT
// Operations that are exact or rounded once.
#include <fixedpoint/arithmetic/saturating.hpp>
#include <fixedpoint/integer_root.hpp>
#include <fixedpoint/math.hpp>

#include "numbers.hpp"

using namespace fixedpoint;

namespace {

void check_operations(const SmallOperations& expected) {
    const Number a = operand(expected.a), b = operand(expected.b), t = operand(expected.t);
    CHECK(lerp(a, b, t).raw() == expected.lerp);
    CHECK(midpoint(a, b).raw() == expected.midpoint);
    CHECK(abs_diff(a, b).raw() == expected.abs_diff);
    CHECK(copysign(a, b).raw() == expected.copysign);
    CHECK(smoothstep(t).raw() == expected.smoothstep);
    CHECK(sign(a) == expected.sign);
    const auto truncated = divrem(a, b), floored = divmod(a, b);
    CHECK(truncated.quotient == expected.quotient);
    CHECK(truncated.remainder.raw() == expected.remainder);
    CHECK(floored.quotient == expected.floored_quotient);
    CHECK(floored.remainder.raw() == expected.floored_remainder);
    using SaturatingNumber = Fixed<INTEGER_BITS, FRACTION_BITS, Saturating>;
    CHECK(lerp(SaturatingNumber::from_raw(a.raw()), SaturatingNumber::from_raw(b.raw()),
               SaturatingNumber::from_raw(t.raw()))
              .raw() == expected.saturated_lerp);
}

// root^2 <= n < (root + 1)^2 for a number hidden from the compiler.
template <class Int, class Square>
void check_root(Int hidden) {
    volatile Int operand = hidden;
    const Int n = operand;
    const Square root = isqrt(n);
    CHECK(root * root <= n && (root + 1) * (root + 1) > n);
}

// The kernels of integer powers compared with the portable code, for mantissas and exponents of
// all lengths.
void check_powers() {
    uint64_t random = 1;
    for (uint16_t i = 0; i < 120; ++i) {
        random = random * 6364136223846793005 + 1442695040888963407;
        const uint16_t n = static_cast<uint16_t>(random >> (48 + i % 16)) | 1;
        const uint16_t short_n = n & 0x7fff;
        volatile uint64_t hidden = random >> (i % 64) | 1;
        const uint64_t a = hidden;
        const uint32_t short_a = static_cast<uint32_t>(random >> 32 >> (i % 32)) | 1;
        for (uint8_t of_reciprocal = 0; of_reciprocal < 2; ++of_reciprocal) {
            const bool reciprocal = of_reciprocal != 0;
            const int8_t unit = static_cast<int8_t>(i % 33);
            CHECK((kernel::short_power<int32_t, 0>(short_a, short_n, unit, reciprocal)) ==
                  (portable::short_power<int32_t, 0>(short_a, short_n, unit, reciprocal)));
            const int8_t long_unit = static_cast<int8_t>(i % 65);
            CHECK((kernel::short_power_64<int64_t, 0>(a, n, long_unit, reciprocal)) ==
                  (portable::short_power_64<int64_t, 0>(a, n, long_unit, reciprocal)));
        }
    }
}

}  // namespace

void test_small_operations() {
    // The 64-bit program has no room for them.
    if (INTEGER_BITS + FRACTION_BITS < 64) check_powers();
    for_each(small_operations, check_operations);
    for (uint16_t n = 0; n < 2000; ++n)
        check_root<uint16_t, uint32_t>(static_cast<uint16_t>(33 * n));
    for (uint32_t n = 1; n < 2000000000; n += n / 2 + 1) check_root<uint32_t, uint64_t>(n);
    check_root<int32_t, int64_t>(2147483647);
    // Squares, the numbers just below them, and some between, until the next square overflows.
    for (uint64_t root = 1; root < UINT32_MAX; root += root / 4 + 1) {
        check_root<uint64_t, uint64_t>(root * root);
        check_root<uint64_t, uint64_t>(root * root - 1);
        check_root<uint64_t, uint64_t>(root * root + root);
        check_root<uint32_t, uint64_t>(static_cast<uint32_t>(root * root));
    }
    CHECK(isqrt(UINT64_MAX) == UINT32_MAX && isqrt(UINT32_MAX) == UINT16_MAX);
    CHECK(isqrt(INT64_MIN) == 0 && isqrt(uint64_t(0)) == 0);
    CHECK(isqrt(-1) == 0 && isqrt(static_cast<int8_t>(127)) == 11);
}
