// SPDX-License-Identifier: MIT
// Integer powers through the kernels of Q32.32: of the formats of up to 32 bits those with at most
// 24 fraction bits, which leave the few bits that these products and reciprocals lose.
#pragma once

#include <fixedpoint/kernel/elementary.hpp>
#include <fixedpoint/portable/integer_power.hpp>

namespace fixedpoint {
namespace kernel {

struct PowerSteps64 {
    // a b0 / 2^32 of a number whose first bit is set, which counts as a sign.
    static FIXEDPOINT_CONSTEXPR uint64_t multiply_by_half(uint64_t a, uint32_t b) {
        return static_cast<uint64_t>(kernel::multiply<int64_t, 32>(static_cast<int64_t>(a),
                                                                   static_cast<int64_t>(b))) +
               (static_cast<uint64_t>(b) << 32);
    }
    // Within 1.5 units of the last place.
    static FIXEDPOINT_CONSTEXPR portable::UpperProduct<uint64_t> multiply(uint64_t a, uint64_t b) {
        const uint64_t low = multiply_by_half(a, static_cast<uint32_t>(b));
        const uint32_t behind = static_cast<uint32_t>(low);
        return {
            multiply_by_half(a, static_cast<uint32_t>(b >> 32)) + static_cast<uint32_t>(low >> 32),
            static_cast<uint8_t>(behind >> 31)};
    }
    // 2^126 / a within 2^-39 of it, from the 40 bits of a in front.
    static FIXEDPOINT_CONSTEXPR uint64_t reciprocal(uint64_t a) {
        return static_cast<uint64_t>(
                   kernel::divide<int64_t, 32>(int64_t(1) << 62, static_cast<int64_t>(a >> 24)))
               << 8;
    }
};

template <class Raw, int F, class Count>
FIXEDPOINT_CONSTEXPR portable::Evaluation<Raw> integer_power(Raw x, Count n, bool reciprocal) {
    using Steps = typename Choice<PowerSteps64, portable::PowerSteps<portable::PowerWord<Raw>>,
                                  (sizeof(Raw) <= 4 && F <= 24)>::Type;
    return portable::integer_power<Raw, F, Steps>(x, n, reciprocal);
}

}  // namespace kernel
}  // namespace fixedpoint
