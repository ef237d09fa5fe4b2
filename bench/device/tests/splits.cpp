// SPDX-License-Identifier: GPL-3.0-or-later
// One operation of every split of SPLIT_BITS, for splits_test.cpp: SPLIT_OPERATION, and
// SPLIT_SHAPE, the macro that defines its subject.
#include <fixedpoint/arithmetic/nearest.hpp>
#include <fixedpoint/kernel/dispatch.hpp>

#include "../subjects/subject.hpp"

using fixedpoint::Nearest;

#define SPLIT(unused, shape, operation, I, F) \
    shape(operation, q##I##_##F, default, fixedpoint::Integer<SPLIT_BITS>, F, Nearest)
#if SPLIT_BITS == 16
#define SPLITS FIXEDPOINT_SPLITS_16
#else
#define SPLITS FIXEDPOINT_SPLITS_32
#endif
SPLITS(SPLIT, , SPLIT_SHAPE, SPLIT_OPERATION)

// The linker keeps what is referred to.
#define SPLIT_ADDRESS(unused, shape, operation, I, F) \
    reinterpret_cast<void (*)()>(operation##_q##I##_##F##_default),
void (*const volatile subjects[])() = {SPLITS(SPLIT_ADDRESS, , SPLIT_SHAPE, SPLIT_OPERATION)};

int main() { return subjects[0] != nullptr; }
