// SPDX-License-Identifier: GPL-3.0-or-later
// A subject is a function of the device program that the bench calls and judges by itself:
// extern "C" <operation>_<format>_<implementation>. These macros define the subjects of one
// operation for a fixed-point format whose arithmetic is a policy of the library.
//
// Subjects are weak, so that the linker can put an assembly kernel in the place of the C++ function
// that would only jump to it (link_subjects.py).
#pragma once

#include <stdint.h>

#define SUBJECT extern "C" __attribute__((weak))

#define SUBJECT_UNARY(operation, format, implementation, Raw, F, Policy) \
    SUBJECT Raw operation##_##format##_##implementation(Raw a) {         \
        return Policy::operation<Raw, F>(a);                             \
    }

#define SUBJECT_BINARY(operation, format, implementation, Raw, F, Policy) \
    SUBJECT Raw operation##_##format##_##implementation(Raw a, Raw b) {   \
        return Policy::operation<Raw, F>(a, b);                           \
    }

#define SUBJECT_TERNARY(operation, format, implementation, Raw, F, Policy)     \
    SUBJECT Raw operation##_##format##_##implementation(Raw a, Raw b, Raw c) { \
        return Policy::operation<Raw, F>(a, b, c);                             \
    }

#define SUBJECT_DOT(operation, format, implementation, Raw, F, Policy)                \
    SUBJECT Raw operation##_##format##_##implementation(const Raw* a, const Raw* b) { \
        return Policy::operation<Raw, F>(a, b);                                       \
    }

#define SUBJECT_LENGTH(operation, format, implementation, Raw, F, Policy) \
    SUBJECT Raw operation##_##format##_##implementation(const Raw* v) {   \
        return Policy::operation<Raw, F>(v);                              \
    }

#define SUBJECT_NORMALISE(operation, format, implementation, Raw, F, Policy)        \
    SUBJECT void operation##_##format##_##implementation(const Raw* v, Raw* unit) { \
        Policy::operation<Raw, F>(v, unit);                                         \
    }

#define SUBJECT_SINCOS(format, implementation, Raw, F, Policy)                         \
    SUBJECT void sincos_##format##_##implementation(Raw angle, Raw* sine_and_cosine) { \
        Policy::sincos<Raw, F>(angle, sine_and_cosine);                                \
    }

// The four operators and the remainder.
#define SUBJECT_OPERATORS(format, implementation, Raw, F, Policy)    \
    SUBJECT_BINARY(add, format, implementation, Raw, F, Policy)      \
    SUBJECT_BINARY(subtract, format, implementation, Raw, F, Policy) \
    SUBJECT_BINARY(multiply, format, implementation, Raw, F, Policy) \
    SUBJECT_BINARY(divide, format, implementation, Raw, F, Policy)
