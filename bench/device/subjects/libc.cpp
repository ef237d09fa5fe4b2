// SPDX-License-Identifier: GPL-3.0-or-later
// avr-libc's emulated IEEE single precision, the rival with which every fixed-point result is
// compared.
#include <math.h>

#include "subject.h"

// The length is a function of its own, since a direction calls it.
SUBJECT float length3_float_libc(const float* v);

struct Libc {
    template <class Float, int>
    static Float add(Float a, Float b) {
        return a + b;
    }
    template <class Float, int>
    static Float subtract(Float a, Float b) {
        return a - b;
    }
    template <class Float, int>
    static Float multiply(Float a, Float b) {
        return a * b;
    }
    template <class Float, int>
    static Float divide(Float a, Float b) {
        return a / b;
    }
    template <class Float, int>
    static Float remainder(Float a, Float b) {
        return fmod(a, b);
    }
    template <class Float, int>
    static Float sqrt(Float a) {
        return ::sqrt(a);
    }
    template <class Float, int>
    static Float reciprocal_sqrt(Float a) {
        return 1.0f / ::sqrt(a);
    }
    template <class Float, int>
    static Float atan(Float a) {
        return ::atan(a);
    }
    template <class Float, int>
    static Float atan2(Float y, Float x) {
        return ::atan2(y, x);
    }
    template <class Float, int>
    static Float sin(Float a) {
        return ::sin(a);
    }
    template <class Float, int>
    static Float cos(Float a) {
        return ::cos(a);
    }
    template <class Float, int>
    static void sincos(Float angle, Float* sine_and_cosine) {
        sine_and_cosine[0] = ::sin(angle);
        sine_and_cosine[1] = ::cos(angle);
    }
    template <class Float, int>
    static Float exp(Float a) {
        return ::exp(a);
    }
    template <class Float, int>
    static Float log(Float a) {
        return ::log(a);
    }
    // avr-libc has no exp2, expm1, log2 and log1p: these are the expressions that programs use
    // instead.
    template <class Float, int>
    static Float exp2(Float a) {
        return ::exp(a * 0.69314718f);
    }
    template <class Float, int>
    static Float expm1(Float a) {
        return ::exp(a) - 1;
    }
    template <class Float, int>
    static Float log2(Float a) {
        return ::log(a) * 1.44269504f;
    }
    template <class Float, int>
    static Float log1p(Float a) {
        return ::log(1 + a);
    }
    template <class Float, int>
    static Float tan(Float a) {
        return ::tan(a);
    }
    template <class Float, int>
    static Float asin(Float a) {
        return ::asin(a);
    }
    template <class Float, int>
    static Float acos(Float a) {
        return ::acos(a);
    }
    template <class Float, int>
    static Float log10(Float a) {
        return ::log10(a);
    }
    template <class Float, int>
    static Float sinh(Float a) {
        return ::sinh(a);
    }
    template <class Float, int>
    static Float cosh(Float a) {
        return ::cosh(a);
    }
    template <class Float, int>
    static Float tanh(Float a) {
        return ::tanh(a);
    }
    template <class Float, int>
    static Float cbrt(Float a) {
        return ::cbrt(a);
    }
    template <class Float, int>
    static Float pow(Float a, Float b) {
        return ::pow(a, b);
    }
    // Nor does it have the following: the expressions that are used instead.
    template <class Float, int>
    static Float sin_turns(Float a) {
        return ::sin(a * 6.28318531f);
    }
    template <class Float, int>
    static Float cos_turns(Float a) {
        return ::cos(a * 6.28318531f);
    }
    template <class Float, int>
    static void sincos_turns(Float angle, Float* sine_and_cosine) {
        sincos<Float, 0>(angle * 6.28318531f, sine_and_cosine);
    }
    template <class Float, int>
    static Float atan2_turns(Float y, Float x) {
        return ::atan2(y, x) * 0.159154943f;
    }
    template <class Float, int>
    static Float sin_degrees(Float a) {
        return ::sin(a * 0.0174532925f);
    }
    template <class Float, int>
    static Float cos_degrees(Float a) {
        return ::cos(a * 0.0174532925f);
    }
    template <class Float, int>
    static void sincos_degrees(Float angle, Float* sine_and_cosine) {
        sincos<Float, 0>(angle * 0.0174532925f, sine_and_cosine);
    }
    template <class Float, int>
    static Float atan2_degrees(Float y, Float x) {
        return ::atan2(y, x) * 57.2957795f;
    }
    template <class Float, int>
    static void divrem(Float a, Float b, Float* quotient_and_remainder) {
        quotient_and_remainder[0] = ::trunc(a / b);
        quotient_and_remainder[1] = ::fmod(a, b);
    }
    template <class Float, int>
    static void divmod(Float a, Float b, Float* quotient_and_remainder) {
        const Float quotient = ::floor(a / b);
        quotient_and_remainder[0] = quotient;
        quotient_and_remainder[1] = a - quotient * b;
    }
    template <class Float, int>
    static Float lerp(Float a, Float b, Float t) {
        return a + t * (b - a);
    }
    template <class Float, int>
    static Float smoothstep(Float a) {
        const Float t = a < 0 ? 0 : a > 1 ? 1 : a;
        return t * t * (3 - 2 * t);
    }
    template <class Float, int>
    static Float midpoint(Float a, Float b) {
        return (a + b) / 2;
    }
    template <class Float, int>
    static Float abs_diff(Float a, Float b) {
        return ::fabs(a - b);
    }
    template <class Float, int>
    static Float copysign(Float a, Float b) {
        return ::copysign(a, b);
    }
    // GCC's own, by squaring, with an int exponent.
    template <class Float, int>
    static Float power(Float a, Float n) {
        return __builtin_powif(a, static_cast<int>(n));
    }
    template <class Float, int>
    static Float sign(Float a) {
        return a < 0 ? -1 : a > 0 ? 1 : 0;
    }
    template <class Float, int>
    static Float isqrt(Float a) {
        return ::floor(::sqrt(a));
    }
    template <class Float, int>
    static Float multiply_add(Float a, Float b, Float c) {
        return a * b + c;
    }
    template <class Float, int>
    static Float dot2(const Float* a, const Float* b) {
        return a[0] * b[0] + a[1] * b[1];
    }
    template <class Float, int>
    static Float dot3(const Float* a, const Float* b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
    template <class Float, int>
    static Float length2(const Float* v) {
        return ::sqrt(v[0] * v[0] + v[1] * v[1]);
    }
    template <class Float, int>
    static Float length3(const Float* v) {
        return ::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
    template <class Float, int>
    static void normalise3(const Float* v, Float* unit) {
        const Float length = length3_float_libc(v);
        const Float scale = length == 0 ? 0 : 1 / length;
        for (uint8_t i = 0; i < 3; ++i) unit[i] = v[i] * scale;
    }
};

IMPLEMENTATION_libc(SUBJECTS) IMPLEMENTATION_libc_elementary(SUBJECTS)
    IMPLEMENTATION_libc_auxiliary(SUBJECTS)
