// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of numbers that are the same in every arithmetic, as a policy: the
// AUXILIARY_OPERATIONS on the host and on the device.
#pragma once

#include <fixedpoint/angle.hpp>
#include <fixedpoint/arithmetic/nearest.hpp>
#include <fixedpoint/integer_root.hpp>
#include <fixedpoint/math.hpp>
#include <fixedpoint/unsigned.hpp>

namespace catalogue {

template <class Raw, int F, bool is_signed = fixedpoint::RawLimits<Raw>::is_signed>
struct NumberOf {
    using Type = fixedpoint::Fixed<fixedpoint::RawLimits<Raw>::width - F, F>;
};
template <class Raw, int F>
struct NumberOf<Raw, F, false> {
    using Type = fixedpoint::UFixed<fixedpoint::RawLimits<Raw>::width - F, F>;
};

struct Functions {
    template <class Raw, int F>
    static constexpr typename NumberOf<Raw, F>::Type of(Raw raw) {
        return NumberOf<Raw, F>::Type::from_raw(raw);
    }

#define UNARY_FUNCTION(name)                          \
    template <class Raw, int F>                       \
    static FIXEDPOINT_CONSTEXPR Raw name(Raw a) {     \
        return fixedpoint::name(of<Raw, F>(a)).raw(); \
    }
    UNARY_FUNCTION(sin_turns)
    UNARY_FUNCTION(cos_turns)
    UNARY_FUNCTION(sin_degrees)
    UNARY_FUNCTION(cos_degrees)
    UNARY_FUNCTION(smoothstep)
#undef UNARY_FUNCTION

#define BINARY_FUNCTION(name)                                        \
    template <class Raw, int F>                                      \
    static FIXEDPOINT_CONSTEXPR Raw name(Raw a, Raw b) {             \
        return fixedpoint::name(of<Raw, F>(a), of<Raw, F>(b)).raw(); \
    }
    BINARY_FUNCTION(atan2_turns)
    BINARY_FUNCTION(atan2_degrees)
    BINARY_FUNCTION(midpoint)
    BINARY_FUNCTION(abs_diff)
    BINARY_FUNCTION(copysign)
#undef BINARY_FUNCTION

#define SINE_AND_COSINE(name)                                                \
    template <class Raw, int F>                                              \
    static FIXEDPOINT_CONSTEXPR void name(Raw angle, Raw* sine_and_cosine) { \
        const auto both = fixedpoint::name(of<Raw, F>(angle));               \
        sine_and_cosine[0] = both.sine.raw();                                \
        sine_and_cosine[1] = both.cosine.raw();                              \
    }
    SINE_AND_COSINE(sincos_turns)
    SINE_AND_COSINE(sincos_degrees)
#undef SINE_AND_COSINE

#define QUOTIENT_AND_REMAINDER(name)                                      \
    template <class Raw, int F>                                           \
    static FIXEDPOINT_CONSTEXPR void name(Raw a, Raw b, Raw* results) {   \
        const auto both = fixedpoint::name(of<Raw, F>(a), of<Raw, F>(b)); \
        results[0] = both.quotient;                                       \
        results[1] = both.remainder.raw();                                \
    }
    QUOTIENT_AND_REMAINDER(divrem)
    QUOTIENT_AND_REMAINDER(divmod)
#undef QUOTIENT_AND_REMAINDER

    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Raw power(Raw a, Raw n) {
        return fixedpoint::power(of<Raw, F>(a), n).raw();
    }
    template <class Raw, int F>
    static constexpr Raw sign(Raw a) {
        return static_cast<Raw>(fixedpoint::sign(of<Raw, F>(a)));
    }
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Raw isqrt(Raw a) {
        return fixedpoint::isqrt(a);
    }
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Raw lerp(Raw a, Raw b, Raw t) {
        return fixedpoint::lerp(of<Raw, F>(a), of<Raw, F>(b), of<Raw, F>(t)).raw();
    }
};

}  // namespace catalogue
