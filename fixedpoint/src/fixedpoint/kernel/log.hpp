// SPDX-License-Identifier: MIT
// The dispatch of log, and of its variant with small tables: which code a format runs through.
#pragma once

#include <fixedpoint/kernel/assembly.hpp>
#include <fixedpoint/kernel/through_q16_16.hpp>
#include <fixedpoint/portable/log.hpp>

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw log(Raw a) {
    return through_q16_16<Raw, F> ? from_q16_16<Raw, F>(log<int32_t, 16>(to_q16_16<Raw, F>(a)))
                                  : portable::log<Raw, F>(a);
}
template <class Raw, int F>
constexpr Raw log_small(Raw a) {
    return portable::log_small<Raw, F>(a);
}

}  // namespace kernel
}  // namespace fixedpoint

FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, log, int32_t, 16, fixedpoint_log_q16_16, log, (int32_t a), (a))
