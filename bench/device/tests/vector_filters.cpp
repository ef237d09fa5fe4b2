// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels of filters, for vector_kernels_test.cpp.
#include <fixedpoint/blocks/filter_kernel.hpp>

// References that keep the linker from dropping them.
int32_t (*const volatile filters[])(int32_t, void*) = {
    fixedpoint_one_pole_q16_16, fixedpoint_one_pole_q8_24, fixedpoint_biquad_q16_16,
    fixedpoint_biquad_q8_24};
#define ADDRESS(KERNEL, shape, name, I, F) fixedpoint::fixedpoint_##name##_q##I##_##F,
int32_t (*const volatile controllers[])(int32_t, int32_t, void*) = {
    fixedpoint::fixedpoint_pid_q16_16, FIXEDPOINT_SPLITS_32(ADDRESS, , , pid)};

int main() { return filters[0] && controllers[0]; }
