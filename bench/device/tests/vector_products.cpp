// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels of matrices, quaternions and polynomials, for vector_kernels_test.cpp.
#include <fixedpoint/blocks/polynomial.hpp>
#include <fixedpoint/kernel/dispatch.hpp>

// References that keep the linker from dropping them.
#define ADDRESS(shape, operation, Raw, F, symbol, same) symbol,
void (*const volatile transforms[])(int32_t*, const int32_t*, const int32_t*, uint8_t) = {
    fixedpoint_transform_q16_16,
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, ADDRESS, TRANSFORM, transform)};
void (*const volatile crosses[])(int32_t*, const int32_t*, const int32_t*) = {
    fixedpoint_cross_q16_16,
    FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, ADDRESS, OUTER, cross)};

// Any numbers, including the ends of the range.
extern "C" {
extern const int32_t coefficients[5] FIXEDPOINT_PROGRAM_MEMORY = {102921, INT32_MIN, -42218,
                                                                  INT32_MAX, 4833};
}
int32_t (*const volatile polynomial)(int32_t, const int32_t*,
                                     uint16_t) = fixedpoint_polynomial_q16_16;

int main() { return transforms[0] && crosses[0] && polynomial(0, coefficients, 5); }
