// SPDX-License-Identifier: GPL-3.0-or-later
// The formats in which every case runs with every method.
#pragma once

// X(name, integer bits, fraction bits). CMakeLists.txt reads these lines.
// clang-format off
#define STABILITY_FORMATS(X) \
    X(q8_8, 8, 8)            \
    X(q16_16, 16, 16)        \
    X(q32_32, 32, 32)        \
    X(q8_24, 8, 24)
// clang-format on
