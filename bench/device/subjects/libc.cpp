// SPDX-License-Identifier: GPL-3.0-or-later
// avr-libc's emulated IEEE single precision, the rival that every fixed-point result is held
// against.
#include <math.h>

#include "subject.hpp"

SUBJECT float add_float_libc(float a, float b) { return a + b; }
SUBJECT float subtract_float_libc(float a, float b) { return a - b; }
SUBJECT float multiply_float_libc(float a, float b) { return a * b; }
SUBJECT float divide_float_libc(float a, float b) { return a / b; }
SUBJECT float remainder_float_libc(float a, float b) { return fmod(a, b); }
SUBJECT float sqrt_float_libc(float a) { return sqrt(a); }
SUBJECT float reciprocal_sqrt_float_libc(float a) { return 1.0f / sqrt(a); }
SUBJECT float atan_float_libc(float a) { return atan(a); }
SUBJECT float atan2_float_libc(float y, float x) { return atan2(y, x); }
SUBJECT float sin_float_libc(float a) { return sin(a); }
SUBJECT float cos_float_libc(float a) { return cos(a); }
SUBJECT void sincos_float_libc(float angle, float* sine_and_cosine) {
    sine_and_cosine[0] = sin(angle);
    sine_and_cosine[1] = cos(angle);
}
SUBJECT float exp_float_libc(float a) { return exp(a); }
SUBJECT float log_float_libc(float a) { return log(a); }
SUBJECT float multiply_add_float_libc(float a, float b, float c) { return a * b + c; }
SUBJECT float dot2_float_libc(const float* a, const float* b) { return a[0] * b[0] + a[1] * b[1]; }
SUBJECT float dot3_float_libc(const float* a, const float* b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
SUBJECT float length2_float_libc(const float* v) { return sqrt(v[0] * v[0] + v[1] * v[1]); }
SUBJECT float length3_float_libc(const float* v) {
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}
SUBJECT void normalise3_float_libc(const float* v, float* unit) {
    const float length = length3_float_libc(v);
    const float scale = length == 0 ? 0 : 1 / length;
    for (uint8_t i = 0; i < 3; ++i) unit[i] = v[i] * scale;
}
