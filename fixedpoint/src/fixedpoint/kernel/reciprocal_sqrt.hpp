// SPDX-License-Identifier: MIT
// The dispatch of reciprocal_sqrt, and of its variant without tables: which code a format runs through.
#pragma once

#include <fixedpoint/kernel/assembly.hpp>
#include <fixedpoint/kernel/divide.hpp>
#include <fixedpoint/kernel/sqrt.hpp>
#include <fixedpoint/kernel/through_q16_16.hpp>
#include <fixedpoint/portable/reciprocal_sqrt.hpp>

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw reciprocal_sqrt(Raw a) {
    return through_q16_16<Raw, F>
               ? from_q16_16<Raw, F>(reciprocal_sqrt<int32_t, 16>(to_q16_16<Raw, F>(a)))
               : portable::reciprocal_sqrt<Raw, F>(a);
}
template <class Raw, int F>
constexpr Raw reciprocal_sqrt_small(Raw a) {
    return through_q16_16<Raw, F>
               ? from_q16_16<Raw, F>(reciprocal_sqrt_small<int32_t, 16>(to_q16_16<Raw, F>(a)))
               : portable::nearest_reciprocal_sqrt<Raw, F>(a);
}

struct SqrtAndDivision {
    static constexpr int64_t sqrt(int64_t a) { return kernel::sqrt<int64_t, 32>(a); }
    static constexpr int64_t divide(int64_t a, int64_t b) {
        return kernel::divide<int64_t, 32>(a, b);
    }
};
template <>
constexpr int64_t reciprocal_sqrt<int64_t, 32>(int64_t a) {
    return portable::reciprocal_sqrt_by_division<SqrtAndDivision>(a);
}

}  // namespace kernel
}  // namespace fixedpoint

FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, reciprocal_sqrt, int32_t, 16, fixedpoint_reciprocal_sqrt_q16_16,
                           reciprocal_sqrt, (int32_t a), (a))
FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, reciprocal_sqrt_small, int32_t, 16,
                           fixedpoint_reciprocal_sqrt_q16_16_small, nearest_reciprocal_sqrt,
                           (int32_t a), (a))
