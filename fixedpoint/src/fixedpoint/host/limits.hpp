// SPDX-License-Identifier: MIT
/// \file
/// std::numeric_limits of fixed-point numbers. As for the standard types, min() is the smallest
/// positive number if there are fraction bits, and the lowest number if there are none.
#pragma once

#include <fixedpoint/fixed.hpp>
#include <limits>

template <int IntegerBits, int F, class A>
class std::numeric_limits<fixedpoint::Fixed<IntegerBits, F, A>> {
    using Number = fixedpoint::Fixed<IntegerBits, F, A>;
    using Raw = typename Number::Raw;

  public:
    static constexpr bool is_specialized = true;
    static constexpr bool is_signed = fixedpoint::RawLimits<Raw>::is_signed;
    static constexpr bool is_integer = F == 0;
    static constexpr bool is_exact = true;
    static constexpr bool is_bounded = true;
    static constexpr bool is_modulo = A::is_modulo;
    static constexpr bool is_iec559 = false;
    static constexpr bool has_infinity = false;
    static constexpr bool has_quiet_NaN = false;
    static constexpr bool has_signaling_NaN = false;
    static constexpr bool has_denorm_loss = false;
    static constexpr bool traps = false;
    static constexpr bool tinyness_before = false;
    static constexpr std::float_denorm_style has_denorm = std::denorm_absent;
    static constexpr std::float_round_style round_style = std::round_to_nearest;

    static constexpr int radix = 2;
    static constexpr int digits = IntegerBits + F - (is_signed ? 1 : 0);
    /// The decimal digits before and after the point that survive a round trip; floor(n
    /// log10(2)) = floor(3 n / 10) for n < 64.
    static constexpr int digits10 = (IntegerBits - (is_signed ? 1 : 0)) * 3 / 10 + F * 3 / 10;
    static constexpr int max_digits10 = 0;
    /// There is no exponent.
    static constexpr int min_exponent = 0;
    static constexpr int min_exponent10 = 0;
    static constexpr int max_exponent = 0;
    static constexpr int max_exponent10 = 0;

    static constexpr Number lowest() noexcept { return Number::min(); }
    static constexpr Number max() noexcept { return Number::max(); }
    static constexpr Number min() noexcept { return F == 0 ? Number::min() : Number::ulp(); }
    static constexpr Number denorm_min() noexcept { return min(); }
    /// The distance between adjacent numbers, the same everywhere in the range.
    static constexpr Number epsilon() noexcept { return Number::ulp(); }
    /// One half, the largest rounding error in ulp; 0 if there are no fraction bits to represent
    /// it.
    static constexpr Number round_error() noexcept {
        return Number::from_raw(static_cast<Raw>((fixedpoint::Unsigned<Raw>(1) << F) >> 1));
    }
    static constexpr Number infinity() noexcept { return Number(); }
    static constexpr Number quiet_NaN() noexcept { return Number(); }
    static constexpr Number signaling_NaN() noexcept { return Number(); }
};
