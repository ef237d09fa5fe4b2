// SPDX-License-Identifier: MIT
// The exponential function of 32-bit numbers of F fraction bits, bit for bit as avr/exp_32.S
// computes it.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/cubic_32.hpp>
#include <fixedpoint/portable/exp_32_table.hpp>
#include <fixedpoint/portable/scale_40.hpp>

namespace fixedpoint {
namespace portable {

// e^-r in units of 2^-39, within 2^-33, for r in units of 2^-40, at most 0.79.
FIXEDPOINT_CONSTEXPR uint64_t exp_mantissa_40(uint64_t r) {
    const Cubic40 core = cubic_40<Exp32Table<>>(static_cast<uint32_t>(r >> 8));
    return (uint64_t(1) << 39) - 1 - core.value - (core.slope * (r & 0xff) >> 8);
}

template <int F>
FIXEDPOINT_CONSTEXPR int32_t exp_32(int32_t a) {
    constexpr int64_t ln2 = 762123384786;  // 2^-40
    // From 31 - F octaves on the result is 2^31 or more; below -F - 2 it is 0.
    if (a > (31 - F) * ln2 >> (40 - F)) return RawLimits<int32_t>::max;
    if (a < -((F + 2) * ln2 >> (40 - F))) return 0;

    // k + F + 9, where a is k ln 2 minus a rest in 0..0.79.
    const int64_t position = static_cast<int64_t>(a) * (int64_t(1) << (32 - F));
    const int32_t whole = static_cast<int32_t>(position >> 32) + 24;
    const int32_t fraction = static_cast<int32_t>(position >> 24 & 0xff);
    const int k = static_cast<int>(
        (whole * 185 + (fraction * 185 >> 8) + 128 * (F + 10) - 24 * 185 + 9) >> 7);
    const uint64_t rest =
        static_cast<uint64_t>((k - (F + 9)) * ln2 - position * 256) & 0xffffffffff;
    return scale_40(exp_mantissa_40(rest), k);
}

}  // namespace portable
}  // namespace fixedpoint
