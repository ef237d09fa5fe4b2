// SPDX-License-Identifier: GPL-3.0-or-later
// The compiler's own integers: what an operation costs without any fixed point.
#include "subject.hpp"

// Sums and products wrap, as the machine's do: computed without sign, where that is defined.
#define NATIVE(format, Type)                                                                     \
    SUBJECT Type add_##format##_native(Type a, Type b) { return Type(u##Type(a) + u##Type(b)); } \
    SUBJECT Type subtract_##format##_native(Type a, Type b) {                                    \
        return Type(u##Type(a) - u##Type(b));                                                    \
    }                                                                                            \
    SUBJECT Type multiply_##format##_native(Type a, Type b) {                                    \
        return Type(u##Type(a) * u##Type(b));                                                    \
    }                                                                                            \
    SUBJECT Type divide_##format##_native(Type a, Type b) { return Type(a / b); }                \
    SUBJECT Type remainder_##format##_native(Type a, Type b) { return Type(a % b); }

NATIVE(int8, int8_t)
NATIVE(int16, int16_t)
NATIVE(int32, int32_t)
NATIVE(int64, int64_t)
