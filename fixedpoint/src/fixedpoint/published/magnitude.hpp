// SPDX-License-Identifier: MIT
// Shared by the published multiplication, division and arc tangent: the quotient of magnitudes and
// the sign flip.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/wide.hpp>

namespace fixedpoint {
namespace published {

// value * flip modulo 2^W; flip must be 1 or -1. The 2016 design restores a sign by a
// multiplication where a conditional negation would do. That is most of the cost of the sign, and
// is kept.
template <class Raw>
constexpr Raw flip_sign(Unsigned<Raw> value, int flip) {
    // 1u: the product of narrow unsigned numbers would otherwise be an int, which must not
    // overflow.
    return static_cast<Raw>(
        static_cast<Unsigned<Raw>>(1u * value * static_cast<Unsigned<Raw>>(flip)));
}

// floor(a 2^F / b) modulo 2^W. b must be greater than 0.
template <class Raw, int F>
struct MagnitudeDivision {
    static constexpr Unsigned<Raw> apply(Unsigned<Raw> a, Unsigned<Raw> b) {
        using Dividend = Unsigned<Wide<Raw>>;
        return static_cast<Unsigned<Raw>>((static_cast<Dividend>(a) << F) / b);
    }
};

// divide_full requires a 64-bit quotient: reducing the upper half first drops what is above.
template <int F>
struct MagnitudeDivision<int64_t, F> {
    static FIXEDPOINT_CONSTEXPR uint64_t apply(uint64_t a, uint64_t b) {
        const uint64_t high = F == 0 ? 0 : a >> (63 - (F - 1));
        return portable::divide_full(high % b, a << F, b).quotient;
    }
};

template <class Raw, int F>
constexpr Unsigned<Raw> divide_magnitudes(Unsigned<Raw> a, Unsigned<Raw> b) {
    return MagnitudeDivision<Raw, F>::apply(a, b);
}

}  // namespace published
}  // namespace fixedpoint
