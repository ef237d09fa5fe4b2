// SPDX-License-Identifier: MIT
// FIXEDPOINT_SPLITS_32(KERNEL): KERNEL(integer bits, fraction bits) of every split of 32 bits but
// Q16.16, whose kernels are its own.
#pragma once

// clang-format off
#define FIXEDPOINT_SPLITS_32(KERNEL) \
    KERNEL(32, 0) \
    KERNEL(31, 1) \
    KERNEL(30, 2) \
    KERNEL(29, 3) \
    KERNEL(28, 4) \
    KERNEL(27, 5) \
    KERNEL(26, 6) \
    KERNEL(25, 7) \
    KERNEL(24, 8) \
    KERNEL(23, 9) \
    KERNEL(22, 10) \
    KERNEL(21, 11) \
    KERNEL(20, 12) \
    KERNEL(19, 13) \
    KERNEL(18, 14) \
    KERNEL(17, 15) \
    KERNEL(15, 17) \
    KERNEL(14, 18) \
    KERNEL(13, 19) \
    KERNEL(12, 20) \
    KERNEL(11, 21) \
    KERNEL(10, 22) \
    KERNEL(9, 23) \
    KERNEL(8, 24) \
    KERNEL(7, 25) \
    KERNEL(6, 26) \
    KERNEL(5, 27) \
    KERNEL(4, 28) \
    KERNEL(3, 29) \
    KERNEL(2, 30) \
    KERNEL(1, 31) \
    KERNEL(0, 32)
// clang-format on
