// SPDX-License-Identifier: GPL-3.0-or-later
// One operation of every split of SPLIT_BITS, for splits_test.cpp: SPLIT_OPERATION of Nearest, or
// of SPLIT_ARITHMETIC.
#include <fixedpoint/arithmetic/saturating.hpp>
#include <fixedpoint/kernel/dispatch.hpp>

#include "../subjects/subject.h"

#ifndef SPLIT_ARITHMETIC
#define SPLIT_ARITHMETIC Nearest
#endif
using Arithmetic = fixedpoint::SPLIT_ARITHMETIC;

#define SPLIT_ROW(operation) OPERATION_##operation
#define SPLIT_SUBJECT(row, I, F) \
    row(SUBJECT_OF_OPERATION, q##I##_##F, fixedpoint::Integer<SPLIT_BITS>, F, default, Arithmetic)
#define SPLIT_OF(operation, I, F) SPLIT_SUBJECT(SPLIT_ROW(operation), I, F)
#define SPLIT(kernel, shape, operation, I, F) SPLIT_OF(operation, I, F)
#if SPLIT_BITS == 16
#define SPLITS FIXEDPOINT_SPLITS_16
#elif SPLIT_BITS == 24
#define SPLITS FIXEDPOINT_SPLITS_24
#elif SPLIT_BITS == 64
// One kernel serves all splits: here where the shifts start and end, and some between. Sines,
// angles and logarithms of the finest ones are portable code.
#ifdef WITHOUT_FINEST_SPLITS
#define FINEST_SPLITS(ROW, KERNEL, shape, operation)
#else
#define FINEST_SPLITS(ROW, KERNEL, shape, operation) \
    ROW(KERNEL, shape, operation, 2, 62)             \
    ROW(KERNEL, shape, operation, 1, 63)
#endif
#define SPLITS(ROW, KERNEL, shape, operation) \
    ROW(KERNEL, shape, operation, 64, 0)      \
    ROW(KERNEL, shape, operation, 63, 1)      \
    ROW(KERNEL, shape, operation, 57, 7)      \
    ROW(KERNEL, shape, operation, 56, 8)      \
    ROW(KERNEL, shape, operation, 48, 16)     \
    ROW(KERNEL, shape, operation, 40, 24)     \
    ROW(KERNEL, shape, operation, 35, 29)     \
    ROW(KERNEL, shape, operation, 33, 31)     \
    ROW(KERNEL, shape, operation, 31, 33)     \
    ROW(KERNEL, shape, operation, 24, 40)     \
    ROW(KERNEL, shape, operation, 16, 48)     \
    ROW(KERNEL, shape, operation, 8, 56)      \
    FINEST_SPLITS(ROW, KERNEL, shape, operation)
#else
#define SPLITS FIXEDPOINT_SPLITS_32
#endif
SPLITS(SPLIT, , , SPLIT_OPERATION)

// References that keep the linker from dropping them.
#define SPLIT_NAME(operation, I, F) operation##_q##I##_##F##_default
#define SPLIT_ADDRESS_OF(operation, I, F) reinterpret_cast<void (*)()>(SPLIT_NAME(operation, I, F)),
#define SPLIT_ADDRESS(kernel, shape, operation, I, F) SPLIT_ADDRESS_OF(operation, I, F)
void (*const volatile subjects[])() = {SPLITS(SPLIT_ADDRESS, , , SPLIT_OPERATION)};

int main() { return subjects[0] != nullptr; }
