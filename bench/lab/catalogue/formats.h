/* SPDX-License-Identifier: GPL-3.0-or-later
 * The formats that are measured in use, as X(name, integer bits, fraction bits): one a line, which
 * CMake reads. The order is that of the rows in data files. */
#ifndef BENCH_LAB_CATALOGUE_FORMATS_H
#define BENCH_LAB_CATALOGUE_FORMATS_H

/* clang-format off */
/* Each scene runs in these with every method. */
#define SCENE_FORMATS(X) \
    X(q8_8, 8, 8)        \
    X(q8_24, 8, 24)      \
    X(q16_16, 16, 16)    \
    X(q32_32, 32, 32)
/* Each case of stability runs in these with every method. */
#define STABILITY_FORMATS(X) \
    X(q8_8, 8, 8)            \
    X(q16_16, 16, 16)        \
    X(q32_32, 32, 32)        \
    X(q8_24, 8, 24)
/* Each block of the library runs in these, and in float. */
#define BLOCK_FORMATS(X) \
    X(q8_8, 8, 8)        \
    X(q16_16, 16, 16)    \
    X(q8_24, 8, 24)
/* clang-format on */

#endif
