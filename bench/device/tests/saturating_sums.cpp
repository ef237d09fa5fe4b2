// SPDX-License-Identifier: GPL-3.0-or-later
// Saturating sums with a constant as neither or one of the operands, inlined as in a program that
// contains one of them.
#include <fixedpoint.h>

#include <fixedpoint/arithmetic/saturating.hpp>

#define SUBJECT(name, result) \
    extern "C" __attribute__((used, noinline, flatten)) Raw name { return (result).raw(); }
#define SUBJECTS(width, I, F, raw_constant)                                                  \
    namespace sums_##width {                                                                 \
        using Number = fixedpoint::Fixed<I, F, fixedpoint::Saturating>;                      \
        using Raw = Number::Raw;                                                             \
        constexpr Number constant = Number::from_raw(raw_constant);                          \
        SUBJECT(sum_##width(Raw a, Raw b), Number::from_raw(a) + Number::from_raw(b))        \
        SUBJECT(difference_##width(Raw a, Raw b), Number::from_raw(a) - Number::from_raw(b)) \
        SUBJECT(sum_with_constant_##width(Raw a), Number::from_raw(a) + constant)            \
        SUBJECT(constant_and_sum_##width(Raw a), constant + Number::from_raw(a))             \
        SUBJECT(difference_from_constant_##width(Raw a), constant - Number::from_raw(a))     \
        SUBJECT(difference_with_constant_##width(Raw a), Number::from_raw(a) - constant)     \
    }
SUBJECTS(16, 8, 8, 0x1234)
SUBJECTS(32, 16, 16, 0x12345678)

int main() {}
