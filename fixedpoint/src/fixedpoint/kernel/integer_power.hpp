// SPDX-License-Identifier: MIT
// Integer powers. Short exponents go through the power kernels. Longer ones, in formats of up to 32
// bits with at most 24 fraction bits, go through the kernels of Q32.32, which have guard bits
// enough for what these products and reciprocals lose.
#pragma once

#include <fixedpoint/kernel/elementary.hpp>
#include <fixedpoint/portable/integer_power.hpp>

namespace fixedpoint {
namespace kernel {

struct PowerSteps64 {
    // a b / 2^32. The leading bit of a is set, which the kernel takes for a sign; the sum corrects
    // that.
    static FIXEDPOINT_CONSTEXPR uint64_t multiply_by_half(uint64_t a, uint32_t b) {
        return static_cast<uint64_t>(kernel::multiply<int64_t, 32>(static_cast<int64_t>(a),
                                                                   static_cast<int64_t>(b))) +
               (static_cast<uint64_t>(b) << 32);
    }
    // Within 1.5 units in the last place.
    static FIXEDPOINT_CONSTEXPR portable::UpperProduct<uint64_t> multiply(uint64_t a, uint64_t b) {
        const uint64_t low = multiply_by_half(a, static_cast<uint32_t>(b));
        const uint32_t behind = static_cast<uint32_t>(low);
        return {
            multiply_by_half(a, static_cast<uint32_t>(b >> 32)) + static_cast<uint32_t>(low >> 32),
            static_cast<uint8_t>(behind >> 31)};
    }
    // 2^126 / a with a relative error below 2^-39, from the upper 40 bits of a.
    static FIXEDPOINT_CONSTEXPR uint64_t reciprocal(uint64_t a) {
        return static_cast<uint64_t>(
                   kernel::divide<int64_t, 32>(int64_t(1) << 62, static_cast<int64_t>(a >> 24)))
               << 8;
    }
};

template <class Number, int F>
struct PowerInUlps;
// Exponents below 2^13 keep the error of the short power at 0.13 ulp or less.
template <int F>
struct PowerInUlps<int32_t, F> {
    template <class Count>
    static FIXEDPOINT_CONSTEXPR uint32_t of(uint32_t magnitude, Count n, bool reciprocal) {
        using Steps =
            typename Choice<PowerSteps64, portable::PowerSteps<uint64_t>, (F <= 24)>::Type;
        return (n & static_cast<Count>(~Count(0x1fff))) == 0
                   ? short_power<int32_t, 0>(magnitude, static_cast<uint16_t>(n),
                                             static_cast<int8_t>(32 - F), reciprocal)
                   : portable::power_in_ulps<int32_t, F, Steps>(magnitude, n, reciprocal);
    }
};
// Below 2^16, hence for every exponent of the chip's int, they leave that of 64 bits 0.09 ulp.
template <int F>
struct PowerInUlps<int64_t, F> {
    template <class Count>
    static FIXEDPOINT_CONSTEXPR uint64_t of(uint64_t magnitude, Count n, bool reciprocal) {
        using Steps = portable::PowerSteps<portable::PowerWord<int64_t>>;
        return (n & static_cast<Count>(~Count(0xffff))) == 0
                   ? short_power_64<int64_t, 0>(magnitude, static_cast<uint16_t>(n),
                                                static_cast<int8_t>(64 - F), reciprocal)
                   : portable::power_in_ulps<int64_t, F, Steps>(magnitude, n, reciprocal);
    }
};

template <class Raw, int F, class Count>
FIXEDPOINT_IN_PLACE Evaluation<Raw> integer_power(Raw x, Count n, bool reciprocal) {
    using Number = portable::PowerNumber<Raw>;
    using Magnitude = Unsigned<Number>;
    constexpr int width = RawLimits<Number>::width;
    constexpr Magnitude beyond = static_cast<Magnitude>(~Magnitude(0));
    constexpr Magnitude one =
        F < width ? static_cast<Magnitude>(Magnitude(1) << F % width) : beyond;
    const bool negative = x < 0 && (static_cast<uint8_t>(n) & 1) != 0;
    const Magnitude ulps = n == 0   ? one
                           : x == 0 ? (reciprocal ? beyond : Magnitude(0))
                                    : PowerInUlps<Number, F>::of(magnitude(x), n, reciprocal);
    if (ulps > static_cast<Magnitude>(RawLimits<Raw>::max) + (negative ? 1 : 0)) {
        return {negative ? RawLimits<Raw>::min : RawLimits<Raw>::max, Outcome::overflow};
    }
    return {with_sign<Raw>(static_cast<Unsigned<Raw>>(ulps), negative), Outcome::in_range};
}

}  // namespace kernel
}  // namespace fixedpoint
