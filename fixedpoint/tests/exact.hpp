// SPDX-License-Identifier: MIT
// The reference for the tests: the definition of every operation in exact arithmetic, for raw
// numbers of any format. The format is an argument, not a template parameter, and the arithmetic is
// hidden in exact.cpp, so that tests need not compile it.
#pragma once

#include <cstdint>
#include <vector>

namespace exact {

// W bits, F of them fraction bits.
struct Format {
    int width;
    int fraction;
};

// An exact value rounded to nearest, half up: modulo 2^W, saturated, and whether the two agree.
struct Rounded {
    int64_t wrapped;
    int64_t saturated;
    bool fits;
};

Rounded add(int64_t a, int64_t b, Format);
Rounded subtract(int64_t a, int64_t b, Format);
Rounded multiply_add(int64_t a, int64_t b, int64_t c, Format);
Rounded dot(const int64_t* a, const int64_t* b, int n, Format);
// b must not be 0.
Rounded divide(int64_t a, int64_t b, Format);
// a 2^shift. If `is_signed` is false, the wrapped and saturated results are the bits of an unsigned
// number.
Rounded scale(__int128 a, int shift, int width, bool is_signed = true);
// n / 10^decimals.
Rounded decimal(int64_t n, int decimals, Format);
// mantissa 2^exponent.
Rounded binary(int64_t mantissa, int exponent, Format);
// 1 / sqrt(a). a must be greater than 0.
Rounded reciprocal_sqrt(int64_t a, Format);
// |v| and the component v_i / |v|. The vector must not be 0.
Rounded length(const int64_t* v, int n, Format);
Rounded normalised(const int64_t* v, int i, Format);

// Whether mantissa 2^exponent is the number with `digits` binary digits closest to a / 2^F, and
// even in a tie.
bool is_nearest_float(int64_t a, int64_t mantissa, int exponent, int digits, Format);

enum class Constant { ln2, sqrt2, golden_ratio, pi, e, ln10, tau, degrees_per_radian };
Rounded constant(Constant, Format);

enum class Function { sin, cos, atan, exp, log, sqrt, reciprocal_sqrt };
Rounded function(Function, int64_t a, Format);
Rounded atan2(int64_t y, int64_t x, Format);
// The distance in ulp of a result from the saturated exact value.
double function_error(Function, int64_t a, int64_t result, Format);
double atan2_error(int64_t y, int64_t x, int64_t result, Format);
double normalise_error(const int64_t* v, int i, int64_t result, Format);

// The step of a loop over operands, and the largest width for which raws() contains every number. A
// sanitizer checks the paths that a program takes, not its results, so fewer operands are enough.
#ifdef SPARSE_OPERANDS
constexpr int operand_step = 7, exhaustive_width = 8;
#else
constexpr int operand_step = 1, exhaustive_width = 16;
#endif

int64_t smallest(int width);
int64_t largest(int width);

// Every number of up to `exhaustive_width` bits. For wider ones, those within 2 of a power of two,
// of either sign, and of the limits, plus `random` ones of every magnitude.
std::vector<int64_t> raws(int width, int random = 50);

}  // namespace exact
