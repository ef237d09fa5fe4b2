// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels of matrices and quaternions, for vector_kernels_test.cpp.
#include <fixedpoint/kernel/dispatch.hpp>

// The linker keeps what is referred to.
#define ADDRESS(shape, operation, Raw, F, symbol, same) symbol,
void (*const volatile transforms[])(int32_t*, const int32_t*, const int32_t*, uint8_t) = {
    fixedpoint_transform_q16_16,
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, ADDRESS, TRANSFORM, transform)};
void (*const volatile crosses[])(int32_t*, const int32_t*, const int32_t*) = {
    fixedpoint_cross_q16_16,
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, ADDRESS, OUTER, cross)};

int main() { return transforms[0] && crosses[0]; }
