// SPDX-License-Identifier: MIT
// divide: floor(a 2^F / b + 1/2), the quotient rounded to nearest, half up, and saturated. If
// b = 0: the largest number if a > 0, the smallest if a < 0, 0 if a = 0.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/wide.hpp>

namespace fixedpoint {
namespace portable {

// A magnitude that saturates: above every Raw with a sign, and the largest Raw without one.
template <class Raw>
constexpr Unsigned<Raw> magnitude_overflow() {
    return static_cast<Unsigned<Raw>>(RawLimits<Raw>::is_signed ? RawLimits<Raw>::min
                                                                : RawLimits<Raw>::max);
}
template <class Raw, class Magnitude>
constexpr bool overflows(Magnitude magnitude) {
    return RawLimits<Raw>::is_signed ? magnitude >> (RawLimits<Raw>::width - 1) != 0
                                     : magnitude >= magnitude_overflow<Raw>();
}

// dividend / divisor, rounded to nearest, half up or half down.
template <class Raw, class Dividend>
FIXEDPOINT_CONSTEXPR Unsigned<Raw> rounded_quotient(Dividend dividend, Unsigned<Raw> divisor,
                                                    bool half_up) {
    const Dividend quotient = static_cast<Dividend>(dividend / divisor);
    if (overflows<Raw>(quotient)) return magnitude_overflow<Raw>();
    const Unsigned<Raw> rest = static_cast<Unsigned<Raw>>(
        static_cast<Unsigned<Raw>>(dividend) - static_cast<Unsigned<Raw>>(quotient) * divisor);
    const Unsigned<Raw> other = static_cast<Unsigned<Raw>>(divisor - rest);
    return static_cast<Unsigned<Raw>>(quotient + (half_up ? rest >= other : rest > other));
}

// The same for a 2^F / b, with a dividend of twice the width.
template <class Raw, int F>
struct WideQuotient {
    static constexpr Unsigned<Raw> rounded(Unsigned<Raw> a, Unsigned<Raw> b, bool half_up) {
        using Dividend = Unsigned<Wide<Raw>>;
        return rounded_quotient<Raw>(static_cast<Dividend>(static_cast<Dividend>(a) << F), b,
                                     half_up);
    }
};
template <class Raw = int64_t>
FIXEDPOINT_CONSTEXPR uint64_t rounded_quotient_64(uint64_t a, uint64_t b, uint8_t fraction,
                                                  bool half_up) {
    const uint64_t high = a >> 1 >> (63 - fraction);
    // The integer part takes at least 64 bits.
    if (high >= b) return magnitude_overflow<Raw>();
    const Division128 division = divide_full(high, a << fraction, b);
    if (overflows<Raw>(division.quotient)) return magnitude_overflow<Raw>();
    const uint64_t rest = division.remainder, other = b - rest;
    return division.quotient + (half_up ? rest >= other : rest > other);
}
template <int F>
struct WideQuotient<int64_t, F> {
    static FIXEDPOINT_CONSTEXPR uint64_t rounded(uint64_t a, uint64_t b, bool half_up) {
        return rounded_quotient_64(a, b, F, half_up);
    }
};
template <int F>
struct WideQuotient<uint64_t, F> {
    static FIXEDPOINT_CONSTEXPR uint64_t rounded(uint64_t a, uint64_t b, bool half_up) {
        return rounded_quotient_64<uint64_t>(a, b, F, half_up);
    }
};

template <class Raw>
constexpr Raw quotient_by_zero(Raw a) {
    return a > 0 ? RawLimits<Raw>::max : a < 0 ? RawLimits<Raw>::min : Raw(0);
}

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw divide(Raw a, Raw b) {
    if (b == 0) return quotient_by_zero(a);
    const bool negative = (a < 0) != (b < 0);
    return saturated_with_sign<Raw>(
        WideQuotient<Raw, F>::rounded(magnitude(a), magnitude(b), !negative), negative);
}

}  // namespace portable
}  // namespace fixedpoint
