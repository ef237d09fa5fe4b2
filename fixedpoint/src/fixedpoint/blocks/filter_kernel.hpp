// SPDX-License-Identifier: MIT
// FilterKernel<Number>: the assembly kernels that execute one step of a filter or a controller.
// They take a pointer to its state, whose layout the .S file describes.
#pragma once

#include <fixedpoint/fixed.hpp>
#include <fixedpoint/kernel/dispatch.hpp>

extern "C" {
int32_t fixedpoint_one_pole_q16_16(int32_t input, void* filter);
int32_t fixedpoint_one_pole_q8_24(int32_t input, void* filter);
int32_t fixedpoint_biquad_q16_16(int32_t input, void* filter);
int32_t fixedpoint_biquad_q8_24(int32_t input, void* filter);
}

namespace fixedpoint {

template <class Number>
struct FilterKernel {
    static constexpr bool exists = false;
};
#define FIXEDPOINT_FILTER_KERNEL(I, F)                                                \
    template <>                                                                       \
    struct FilterKernel<Fixed<I, F>> {                                                \
        using Number = Fixed<I, F>;                                                   \
        static constexpr bool exists = kernel::has_assembly;                          \
        static Number one_pole(Number x, void* filter) {                              \
            return Number::from_raw(fixedpoint_one_pole_q##I##_##F(x.raw(), filter)); \
        }                                                                             \
        static Number biquad(Number x, void* filter) {                                \
            return Number::from_raw(fixedpoint_biquad_q##I##_##F(x.raw(), filter));   \
        }                                                                             \
    };
FIXEDPOINT_FILTER_KERNEL(16, 16)
FIXEDPOINT_FILTER_KERNEL(8, 24)
#undef FIXEDPOINT_FILTER_KERNEL

// For every 32-bit format.
template <int F>
struct PidKernel;
#define FIXEDPOINT_PID_KERNEL(KERNEL, shape, name, I, F)                                 \
    extern "C" int32_t fixedpoint_pid_q##I##_##F(int32_t setpoint, int32_t measurement,  \
                                                 void* controller);                      \
    template <>                                                                          \
    struct PidKernel<F> {                                                                \
        static int32_t update(int32_t setpoint, int32_t measurement, void* controller) { \
            return fixedpoint_pid_q##I##_##F(setpoint, measurement, controller);         \
        }                                                                                \
    };
FIXEDPOINT_PID_KERNEL(, , pid, 16, 16)
FIXEDPOINT_SPLITS_32(FIXEDPOINT_PID_KERNEL, , , pid)
#undef FIXEDPOINT_PID_KERNEL

}  // namespace fixedpoint
