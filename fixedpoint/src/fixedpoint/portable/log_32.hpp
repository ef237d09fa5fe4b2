// SPDX-License-Identifier: MIT
// The natural logarithm of 32-bit numbers of F fraction bits, bit for bit as avr/log_32.S computes
// it.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/cubic_32.hpp>
#include <fixedpoint/portable/log_32_table.hpp>

namespace fixedpoint {
namespace portable {

// In units of 2^-31, plus one for the truncation in the core; beyond 24 fraction bits in units of
// 2^-39. a must be greater than 0.
template <int F>
FIXEDPOINT_CONSTEXPR int64_t unrounded_log_32(int32_t a) {
    uint32_t normalised = static_cast<uint32_t>(a);
    int exponent = 31;
    while (normalised >> 31 == 0) {
        normalised <<= 1;
        --exponent;
    }
    constexpr int64_t ln2 = 381061692393;  // 2^-39
    const int64_t multiple = exponent * ln2;
    return is_coarse_32<F>() ? static_cast<int64_t>(cubic_32<Log32Table<>>(normalised << 1)) +
                                   (multiple >> 8) + 1 - (F * ln2 >> 8)
                             : static_cast<int64_t>(cubic_40<Log32Table<>>(normalised << 1).value) +
                                   multiple - F * ln2;
}

template <int F>
FIXEDPOINT_CONSTEXPR int32_t log_32(int32_t a) {
    if (a <= 0) return RawLimits<int32_t>::min;
    constexpr int surplus = is_coarse_32<F>() ? 0 : 8;
    // In units of 2^-31, with half an ulp added.
    int64_t sum = (unrounded_log_32<F>(a) + (int64_t(1) << (30 + surplus - F))) >> surplus;
    sum = F > 31 ? sum * 2 : sum >> (F > 31 ? 0 : 31 - F);
    return sum < RawLimits<int32_t>::min ? RawLimits<int32_t>::min : static_cast<int32_t>(sum);
}

}  // namespace portable
}  // namespace fixedpoint
