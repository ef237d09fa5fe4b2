// SPDX-License-Identifier: GPL-3.0-or-later
// FUNCTIONS of CorrectlyRounded in a split, Q<INTEGER_BITS>.<FRACTION_BITS> with 8, 16 or 32 bits,
// for correctly_rounded_splits_on_chip_test.cpp.
#include <fixedpoint/arithmetic/correctly_rounded.hpp>

#include "../subjects/subject.h"

using fixedpoint::CorrectlyRounded;
using Raw = fixedpoint::Integer<INTEGER_BITS + FRACTION_BITS>;

FUNCTIONS(SUBJECT_OF_OPERATION, split, Raw, FRACTION_BITS, correctly_rounded, CorrectlyRounded)

// References that keep the linker from dropping them.
#define ADDRESS(name, ...) reinterpret_cast<void (*)()>(name##_split_correctly_rounded),
void (*const volatile subjects[])() = {FUNCTIONS(ADDRESS)};

int main() { return subjects[0] != nullptr; }
