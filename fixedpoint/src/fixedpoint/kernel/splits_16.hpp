// SPDX-License-Identifier: MIT
// FIXEDPOINT_SPLITS_16(KERNEL): KERNEL(integer bits, fraction bits) of every split of 16 bits but
// Q8.8, whose kernels are its own.
#pragma once

// clang-format off
#define FIXEDPOINT_SPLITS_16(KERNEL) \
    KERNEL(16, 0) \
    KERNEL(15, 1) \
    KERNEL(14, 2) \
    KERNEL(13, 3) \
    KERNEL(12, 4) \
    KERNEL(11, 5) \
    KERNEL(10, 6) \
    KERNEL(9, 7) \
    KERNEL(7, 9) \
    KERNEL(6, 10) \
    KERNEL(5, 11) \
    KERNEL(4, 12) \
    KERNEL(3, 13) \
    KERNEL(2, 14) \
    KERNEL(1, 15) \
    KERNEL(0, 16)
// clang-format on
