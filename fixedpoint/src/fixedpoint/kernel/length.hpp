// SPDX-License-Identifier: MIT
// The dispatch of length2 and length3: which code a format runs through.
#pragma once

#include <fixedpoint/kernel/assembly.hpp>
#include <fixedpoint/kernel/splits_32.hpp>
#include <fixedpoint/kernel/through_q16_16.hpp>
#include <fixedpoint/portable/length.hpp>

namespace fixedpoint {
namespace kernel {

// The length of raw numbers is the raw length, rounded once. Formats of up to 13 fraction bits
// round it from Q16.16.
template <class Raw, int F>
constexpr Raw length2(const Raw* v) {
    if (has_assembly && sizeof(Raw) <= 2 && !through_q16_16<Raw, F>) {
        const int32_t raw[2] = {static_cast<int32_t>(v[0]), static_cast<int32_t>(v[1])};
        return clamped<Raw>(length2<int32_t, 16>(raw));
    }
    if (!through_q16_16<Raw, F>) return portable::length2<Raw, F>(v);
    const int32_t wide[2] = {to_q16_16<Raw, F>(v[0]), to_q16_16<Raw, F>(v[1])};
    return from_q16_16<Raw, F>(length2<int32_t, 16>(wide));
}
template <class Raw, int F>
constexpr Raw length3(const Raw* v) {
    if (has_assembly && sizeof(Raw) <= 2 && !through_q16_16<Raw, F>) {
        const int32_t raw[3] = {static_cast<int32_t>(v[0]), static_cast<int32_t>(v[1]),
                                static_cast<int32_t>(v[2])};
        return clamped<Raw>(length3<int32_t, 16>(raw));
    }
    if (!through_q16_16<Raw, F>) return portable::length3<Raw, F>(v);
    const int32_t wide[3] = {to_q16_16<Raw, F>(v[0]), to_q16_16<Raw, F>(v[1]),
                             to_q16_16<Raw, F>(v[2])};
    return from_q16_16<Raw, F>(length3<int32_t, 16>(wide));
}

}  // namespace kernel
}  // namespace fixedpoint

FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, length2, int32_t, 16, fixedpoint_length2_q16_16, length2,
                           (const int32_t* v), (v))
FIXEDPOINT_ASSEMBLY_KERNEL(int32_t, length3, int32_t, 16, fixedpoint_length3_q16_16, length3,
                           (const int32_t* v), (v))
FIXEDPOINT_ASSEMBLY_KERNEL(int64_t, length2, int64_t, 32, fixedpoint_length2_q32_32, length2,
                           (const int64_t* v), (v))
FIXEDPOINT_ASSEMBLY_KERNEL(int64_t, length3, int64_t, 32, fixedpoint_length3_q32_32, length3,
                           (const int64_t* v), (v))

// The fraction bits cancel: every split of 32 bits has the lengths of Q16.16.
#ifdef __AVR__
#define FIXEDPOINT_LENGTH(I, F)                               \
    namespace fixedpoint {                                    \
    namespace kernel {                                        \
    template <>                                               \
    constexpr int32_t length2<int32_t, F>(const int32_t* v) { \
        return fixedpoint_length2_q16_16(v);                  \
    }                                                         \
    template <>                                               \
    constexpr int32_t length3<int32_t, F>(const int32_t* v) { \
        return fixedpoint_length3_q16_16(v);                  \
    }                                                         \
    }                                                         \
    }
FIXEDPOINT_SPLITS_32(FIXEDPOINT_LENGTH)
#undef FIXEDPOINT_LENGTH
#endif
