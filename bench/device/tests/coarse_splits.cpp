// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels of the splits of 16 bits with less than 8 fraction bits, for coarse_splits_test.cpp.
#include <fixedpoint/kernel/table.hpp>

#define DECLARATION(kernel, shape, operation, I, F) \
    extern "C" void fixedpoint_##operation##_q##I##_##F();
#define ADDRESS(kernel, shape, operation, I, F) fixedpoint_##operation##_q##I##_##F,
#define EACH(ROW)                             \
    FIXEDPOINT_COARSE_SPLITS_16(ROW, , , sin) \
    FIXEDPOINT_COARSE_SPLITS_16(ROW, , , cos) \
    FIXEDPOINT_COARSE_SPLITS_16(ROW, , , sincos) FIXEDPOINT_COARSE_SPLITS_16(ROW, , , log)

EACH(DECLARATION)

// References that keep the linker from dropping them.
void (*const volatile kernels[])() = {EACH(ADDRESS)};

int main() { return kernels[0] != nullptr; }
