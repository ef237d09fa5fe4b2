// SPDX-License-Identifier: MIT
// Operations on numbers and integers, and widening sums and products.
#include <fixedpoint/arithmetic/saturating.hpp>
#include <fixedpoint/constants.hpp>
#include <fixedpoint/widening.hpp>

#include "numbers.hpp"

using namespace fixedpoint;

static_assert(fixed<16, 16>(0.38).raw() == 24904, "a float of 24 bits");
static_assert(fixed<8, 8>(-128).raw() == -32768, "an integer of 16 bits");
static_assert(constants::pi<Q32_32>().raw() == 13493037705, "pi 2^32 = 13493037704.52");

namespace {

template <class Result, class Int>
void check_ring(Result a, Int n, const Raw* expected) {
    CHECK((a + n).raw() == expected[0] && (n + a).raw() == expected[0]);
    CHECK((a - n).raw() == expected[1]);
    CHECK((n - a).raw() == expected[2]);
    CHECK((a * n).raw() == expected[3] && (n * a).raw() == expected[3]);
}

template <class Int>
void check_type(const WithInteger& expected) {
    volatile Int hidden = static_cast<Int>(expected.n);
    const Int n = hidden;
    if (static_cast<int32_t>(n) != expected.n) return;
    const Number a = operand(expected.a);
    check_ring(a, n, expected.wrapped);
    check_ring(Fixed<INTEGER_BITS, FRACTION_BITS, Saturating>::from_raw(a.raw()), n,
               expected.saturated);
    CHECK((a / n).raw() == expected.quotient);
    CHECK((a == n) == (expected.comparison == 0) && (n != a) == (expected.comparison != 0));
    CHECK((a < n) == (expected.comparison < 0) && (n >= a) == (expected.comparison <= 0));
    CHECK((a > n) == (expected.comparison > 0) && (n <= a) == (expected.comparison >= 0));
}

void check_types(const WithInteger& expected) {
    check_type<int>(expected);
    // With 64 bits, more than one type does not fit in flash.
    if (sizeof(Raw) == 8) return;
    check_type<int8_t>(expected);
    check_type<uint8_t>(expected);
    check_type<unsigned>(expected);
    check_type<long>(expected);
}

// No format is wider than 64 bits.
template <bool widens, class Any>
struct Widening {
    static void check(Any a, Any b, const Pair& expected) {
        CHECK(narrow<Any>(widening_multiply(a, b)).raw() == expected.saturated_product);
        CHECK(narrow<Any>(widening_add(a, b)).raw() == expected.saturated_sum);
    }
};
template <class Any>
struct Widening<false, Any> {
    static void check(Any, Any, const Pair&) {}
};
void check_widening(const Pair& expected) {
    Widening<sizeof(Raw) <= 4, Number>::check(operand(expected.a), operand(expected.b), expected);
}

// Compilers turn a product with this constant into a shift; that with a variable is checked above.
void check_constant_factor(const WithInteger& expected) {
    const volatile int32_t hidden = 65536;
    const Number a = operand(expected.a);
    const int32_t factor = hidden;
    CHECK((a * int32_t(65536)).raw() == (a * factor).raw());
}

}  // namespace

void test_integers() {
    for_each(with_integers, check_constant_factor);
    for_each(with_integers, check_types);
    for_each(pairs, check_widening);
}
