// SPDX-License-Identifier: MIT
// The dispatch of exp, and of its variant with small tables: which code a format runs through.
#pragma once

#include <fixedpoint/kernel/assembly.hpp>
#include <fixedpoint/kernel/through_q16_16.hpp>
#include <fixedpoint/portable/exp.hpp>

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw exp(Raw a) {
    return through_q16_16<Raw, F> ? from_q16_16<Raw, F>(exp<int32_t, 16>(to_q16_16<Raw, F>(a)))
                                  : portable::exp<Raw, F>(a);
}
template <class Raw, int F>
constexpr Raw exp_small(Raw a) {
    return portable::exp_small<Raw, F>(a);
}

}  // namespace kernel
}  // namespace fixedpoint

FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, exp, int32_t, 16, fixedpoint_exp_q16_16, exp, (int32_t a), (a))
