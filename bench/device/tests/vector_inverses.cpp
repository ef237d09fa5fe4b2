// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels of matrix inverses, for vector_kernels_test.cpp.
#include <fixedpoint/blocks/matrix.hpp>

// References that keep the linker from dropping them.
#define INVERSE(KERNEL, shape, name, I, F) fixedpoint::fixedpoint_invert2_q##I##_##F,
uint8_t (*const volatile inverses[])(const int32_t*, int32_t*) = {
    fixedpoint_invert2_q16_16, FIXEDPOINT_SPLITS_32(INVERSE, , , )};
#define QUOTIENTS(KERNEL, shape, name, I, F) fixedpoint::fixedpoint_transposed_quotients_q##I##_##F,
void (*const volatile quotients[])(int32_t*, const int32_t*, int32_t,
                                   uint8_t) = {FIXEDPOINT_SPLITS_32(QUOTIENTS, , , )};

int main() { return inverses[0] && quotients[0]; }
