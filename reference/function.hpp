// SPDX-License-Identifier: GPL-3.0-or-later
// Every function of plain numbers, once for all types in which it is computed: Real for the exact
// value; double and binary128 for the bulk judge, which must be fast; float, whose special cases
// are those of C's Annex F.
#pragma once

#include <cmath>
#include <stdexcept>

#include "reference/operation.hpp"

// Part of the C library, on x86-64 for every compiler.
extern "C" {
__extension__ __float128 sinf128(__float128) noexcept;
__extension__ __float128 cosf128(__float128) noexcept;
__extension__ __float128 atanf128(__float128) noexcept;
__extension__ __float128 atan2f128(__float128, __float128) noexcept;
__extension__ __float128 expf128(__float128) noexcept;
__extension__ __float128 logf128(__float128) noexcept;
__extension__ __float128 tanf128(__float128) noexcept;
__extension__ __float128 asinf128(__float128) noexcept;
__extension__ __float128 acosf128(__float128) noexcept;
__extension__ __float128 exp2f128(__float128) noexcept;
__extension__ __float128 expm1f128(__float128) noexcept;
__extension__ __float128 log2f128(__float128) noexcept;
__extension__ __float128 log10f128(__float128) noexcept;
__extension__ __float128 log1pf128(__float128) noexcept;
__extension__ __float128 sinhf128(__float128) noexcept;
__extension__ __float128 coshf128(__float128) noexcept;
__extension__ __float128 tanhf128(__float128) noexcept;
__extension__ __float128 cbrtf128(__float128) noexcept;
__extension__ __float128 powf128(__float128, __float128) noexcept;
__extension__ __float128 sqrtf128(__float128) noexcept;
__extension__ __float128 floorf128(__float128) noexcept;
}

namespace reference {

__extension__ using Binary128 = __float128;

namespace functions {
using std::atan, std::atan2, std::cos, std::exp, std::floor, std::log, std::sin, std::sqrt;
using std::tan, std::asin, std::acos, std::exp2, std::expm1, std::log2, std::log10, std::log1p,
    std::sinh, std::cosh, std::tanh, std::cbrt, std::pow;
inline Binary128 sin(Binary128 x) { return sinf128(x); }
inline Binary128 cos(Binary128 x) { return cosf128(x); }
inline Binary128 atan(Binary128 x) { return atanf128(x); }
inline Binary128 atan2(Binary128 y, Binary128 x) { return atan2f128(y, x); }
inline Binary128 exp(Binary128 x) { return expf128(x); }
inline Binary128 log(Binary128 x) { return logf128(x); }
inline Binary128 tan(Binary128 x) { return tanf128(x); }
inline Binary128 asin(Binary128 x) { return asinf128(x); }
inline Binary128 acos(Binary128 x) { return acosf128(x); }
inline Binary128 exp2(Binary128 x) { return exp2f128(x); }
inline Binary128 expm1(Binary128 x) { return expm1f128(x); }
inline Binary128 log2(Binary128 x) { return log2f128(x); }
inline Binary128 log10(Binary128 x) { return log10f128(x); }
inline Binary128 log1p(Binary128 x) { return log1pf128(x); }
inline Binary128 sinh(Binary128 x) { return sinhf128(x); }
inline Binary128 cosh(Binary128 x) { return coshf128(x); }
inline Binary128 tanh(Binary128 x) { return tanhf128(x); }
inline Binary128 cbrt(Binary128 x) { return cbrtf128(x); }
inline Binary128 pow(Binary128 x, Binary128 y) { return powf128(x, y); }
inline Binary128 sqrt(Binary128 x) { return sqrtf128(x); }
inline Binary128 floor(Binary128 x) { return floorf128(x); }
}  // namespace functions

// The angle in radians, reduced to within half a turn. `turn` is a whole turn in the unit of
// `angle`.
template <class Number>
Number radians(const Number& angle, int turn) {
    using functions::floor, functions::atan;
    static const Number tau = 8 * atan(Number(1));
    const Number rest = angle - turn * floor(Number(angle / turn + Number(0.5)));
    return rest * tau / turn;
}
// An angle in radians in the unit of which `turn` is a whole turn.
template <class Number>
Number part_of_turn(const Number& radians, int turn) {
    using functions::atan;
    static const Number tau = 8 * atan(Number(1));
    return radians * turn / tau;
}

// The operands must lie in the operation's domain, unless Number has values outside it. Inlined,
// since the bulk judge knows the operation at compile time.
template <class Number>
[[gnu::always_inline]] inline Number function(Operation operation, const Number* x) {
    using functions::sqrt, functions::atan, functions::atan2, functions::sin, functions::cos,
        functions::exp, functions::log, functions::tan, functions::asin, functions::acos,
        functions::exp2, functions::expm1, functions::log2, functions::log10, functions::log1p,
        functions::sinh, functions::cosh, functions::tanh, functions::cbrt, functions::pow;
    switch (operation) {
        case Operation::sqrt:
            return sqrt(x[0]);
        case Operation::reciprocal_sqrt:
            return 1 / sqrt(x[0]);
        case Operation::atan:
            return atan(x[0]);
        case Operation::atan2:
            return atan2(x[0], x[1]);
        case Operation::sin:
            return sin(x[0]);
        case Operation::cos:
            return cos(x[0]);
        case Operation::exp:
            return exp(x[0]);
        case Operation::log:
            return log(x[0]);
        case Operation::tan:
            return tan(x[0]);
        case Operation::asin:
            return asin(x[0]);
        case Operation::acos:
            return acos(x[0]);
        case Operation::exp2:
            return exp2(x[0]);
        case Operation::expm1:
            return expm1(x[0]);
        case Operation::log2:
            return log2(x[0]);
        case Operation::log10:
            return log10(x[0]);
        case Operation::log1p:
            return log1p(x[0]);
        case Operation::sinh:
            return sinh(x[0]);
        case Operation::cosh:
            return cosh(x[0]);
        case Operation::tanh:
            return tanh(x[0]);
        case Operation::cbrt:
            return cbrt(x[0]);
        case Operation::pow:
            return pow(x[0], x[1]);
        case Operation::sin_turns:
            return sin(radians(x[0], 1));
        case Operation::cos_turns:
            return cos(radians(x[0], 1));
        case Operation::atan2_turns:
            return part_of_turn(Number(atan2(x[0], x[1])), 1);
        case Operation::sin_degrees:
            return sin(radians(x[0], 360));
        case Operation::cos_degrees:
            return cos(radians(x[0], 360));
        case Operation::atan2_degrees:
            return part_of_turn(Number(atan2(x[0], x[1])), 360);
        case Operation::power:
            return x[1] == 0 ? Number(1) : Number(pow(x[0], x[1]));
        default:
            throw std::logic_error("an operation that is no function of plain numbers");
    }
}

}  // namespace reference
