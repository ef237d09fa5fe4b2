// SPDX-License-Identifier: MIT
// Operators, rounding and conversions in constant expressions.
#include <fixedpoint/arithmetic/saturating.hpp>
#include <fixedpoint/math.hpp>

#include "constant.hpp"
#include "numbers.hpp"

using namespace fixedpoint;

namespace {

constexpr Number polynomial(Number x, Number y) { return (x * y + x) * y - x / y; }

template <Raw A, Raw B>
void check_operators() {
    CHECK_CONSTANT(polynomial(x, y));
    CHECK_CONSTANT(x + y);
    CHECK_CONSTANT(x - y);
    CHECK_CONSTANT(x * y);
    CHECK_CONSTANT(x / y);
    CHECK_CONSTANT(x % y);
    CHECK_CONSTANT(-x);
    CHECK_CONSTANT(x << 3);
    CHECK_CONSTANT(x >> 3);
    CHECK_CONSTANT(x == y);
    CHECK_CONSTANT(x != y);
    CHECK_CONSTANT(x < y);
    CHECK_CONSTANT(x > y);
    CHECK_CONSTANT(x <= y);
    CHECK_CONSTANT(x >= y);
    CHECK_CONSTANT(as<Saturating>(x) + as<Saturating>(y));
    CHECK_CONSTANT(as<Saturating>(x) - as<Saturating>(y));
    CHECK_CONSTANT(as<Saturating>(x) * as<Saturating>(y));
    CHECK_CONSTANT(-as<Saturating>(x));
    CHECK_CONSTANT(as<Saturating>(x) << 3);
}

template <Raw A, Raw B>
void check_rounding() {
    CHECK_CONSTANT(abs(x));
    CHECK_CONSTANT(min(x, y));
    CHECK_CONSTANT(max(x, y));
    CHECK_CONSTANT(clamp(Number(), x, y));
    CHECK_CONSTANT(floor(x));
    CHECK_CONSTANT(ceil(x));
    CHECK_CONSTANT(round(x));
    CHECK_CONSTANT(trunc(x));
    CHECK_CONSTANT(convert<Q4_4>(x));
    CHECK_CONSTANT(convert<Q32_32>(x));
    CHECK_CONSTANT(convert_checked<Q8_8>(x).number);
    CHECK_CONSTANT(convert_checked<int16_t>(x).fits);
    CHECK_CONSTANT(to_float<float>(x));
    CHECK_CONSTANT(from_decimal<Number>(x.raw(), 3));
}

}  // namespace

void test_constants() {
    check_operators<third, fifth>();
    check_operators<RawLimits<Raw>::min, Raw(-1)>();
    check_operators<above_one, below_one>();
    check_rounding<third, fifth>();
    check_rounding<fifth, third>();
    check_rounding<RawLimits<Raw>::min, RawLimits<Raw>::max>();
}
