// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels of filters and of an inverse, for vector_kernels_test.cpp.
#include <fixedpoint/blocks/filter_kernel.hpp>
#include <fixedpoint/blocks/matrix.hpp>

// References that keep the linker from dropping them.
int32_t (*const volatile filters[])(int32_t, void*) = {
    fixedpoint_one_pole_q16_16, fixedpoint_one_pole_q8_24, fixedpoint_biquad_q16_16,
    fixedpoint_biquad_q8_24};
int32_t (*const volatile controller)(int32_t, int32_t, void*) = fixedpoint_pid_q16_16;
uint8_t (*const volatile inverse)(const int32_t*, int32_t*) = fixedpoint_invert2_q16_16;

int main() { return filters[0] && controller && inverse; }
