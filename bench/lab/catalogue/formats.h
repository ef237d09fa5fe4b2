/* SPDX-License-Identifier: GPL-3.0-or-later
 * The formats of the library that are measured. CMake and the report read them here, too. The order
 * is that of the rows in data files. */
#ifndef BENCH_LAB_CATALOGUE_FORMATS_H
#define BENCH_LAB_CATALOGUE_FORMATS_H

/* In all operations, as X(name, raw type, fraction bits, ...). Each FORMAT_q has a device program
 * of its own. */
/* clang-format off */
#define FORMAT_q4_4(X, ...)   X(q4_4, int8_t, 4, __VA_ARGS__)
#define FORMAT_q8_8(X, ...)   X(q8_8, int16_t, 8, __VA_ARGS__)
#define FORMAT_q8_16(X, ...)  X(q8_16, ::fixedpoint::Int24, 16, __VA_ARGS__)
#define FORMAT_q12_12(X, ...) X(q12_12, ::fixedpoint::Int24, 12, __VA_ARGS__)
#define FORMAT_q16_16(X, ...) X(q16_16, int32_t, 16, __VA_ARGS__)
#define FORMAT_q8_24(X, ...)  X(q8_24, int32_t, 24, __VA_ARGS__)
#define FORMAT_q32_32(X, ...) X(q32_32, int64_t, 32, __VA_ARGS__)
/* Without a sign: their operations are in one program. */
#define FORMAT_u8_8(X, ...)   X(u8_8, uint16_t, 8, __VA_ARGS__)
#define FORMAT_u16_16(X, ...) X(u16_16, uint32_t, 16, __VA_ARGS__)
/* clang-format on */

#define UNSIGNED_FORMATS(X, ...) FORMAT_u8_8(X, __VA_ARGS__) FORMAT_u16_16(X, __VA_ARGS__)
#define SQUARE_FORMATS(X, ...)                                                            \
    FORMAT_q4_4(X, __VA_ARGS__) FORMAT_q8_8(X, __VA_ARGS__) FORMAT_q16_16(X, __VA_ARGS__) \
        FORMAT_q32_32(X, __VA_ARGS__)
#define LIBRARY_FORMATS(X, ...)                                                                  \
    FORMAT_q4_4(X, __VA_ARGS__) FORMAT_q8_8(X, __VA_ARGS__) FORMAT_q8_16(X, __VA_ARGS__)         \
        FORMAT_q12_12(X, __VA_ARGS__) FORMAT_q16_16(X, __VA_ARGS__) FORMAT_q8_24(X, __VA_ARGS__) \
            FORMAT_q32_32(X, __VA_ARGS__)

/* In use, as X(name, integer bits, fraction bits), one a line. */
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
