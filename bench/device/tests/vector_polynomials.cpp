// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels of polynomials and of the renormalisation of quaternions, for
// vector_kernels_test.cpp.
#include <fixedpoint/blocks/polynomial.hpp>
#include <fixedpoint/blocks/quaternion.hpp>

// References that keep the linker from dropping them.
#define ADDRESS(KERNEL, shape, name, I, F) fixedpoint::fixedpoint_polynomial_q##I##_##F,
int32_t (*const volatile polynomials[])(int32_t, const int32_t*, uint16_t) = {
    ADDRESS(, , , 16, 16) FIXEDPOINT_SPLITS_32(ADDRESS, , , )};
#define AMPLIFY(KERNEL, shape, name, I, F) fixedpoint::fixedpoint_amplify4_q##I##_##F,
void (*const volatile amplifiers[])(int32_t*, int32_t) = {FIXEDPOINT_SPLITS_32(AMPLIFY, , , )};

// Any numbers, including the ends of the range.
extern "C" {
extern const int32_t coefficients[5] FIXEDPOINT_PROGRAM_MEMORY = {102921, INT32_MIN, -42218,
                                                                  INT32_MAX, 4833};
}

int main() { return amplifiers[0] && polynomials[0](0, coefficients, 5); }
