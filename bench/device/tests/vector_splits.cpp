// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels of OPERATION for every 32-bit format, for vector_kernels_test.cpp.
#include <fixedpoint/kernel/dispatch.hpp>

// References that keep the linker from dropping them.
#define ADDRESS(shape, operation, Raw, F, symbol, same) reinterpret_cast<void (*)()>(symbol),
#define ADDRESS_OF_Q16_16(operation) FIXEDPOINT_KERNEL_OF_SPLIT_32(ADDRESS, , operation, 16, 16)
void (*const volatile kernels[])() = {
    ADDRESS_OF_Q16_16(OPERATION)
        FIXEDPOINT_SPLITS_32(FIXEDPOINT_KERNEL_OF_SPLIT_32, ADDRESS, , OPERATION)};

int main() { return kernels[0] != nullptr; }
