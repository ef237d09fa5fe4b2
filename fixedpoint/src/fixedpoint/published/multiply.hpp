// SPDX-License-Identifier: MIT
// multiply: a b / 2^F truncated toward zero, modulo 2^W, by the algorithm of the 2016 design.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/wide.hpp>
#include <fixedpoint/published/magnitude.hpp>

namespace fixedpoint {
namespace published {

template <class Raw, int F>
struct MagnitudeProduct {
    static constexpr Unsigned<Raw> apply(Unsigned<Raw> a, Unsigned<Raw> b) {
        using Product = Unsigned<Wide<Raw>>;
        return static_cast<Unsigned<Raw>>((static_cast<Product>(a) * b) >> F);
    }
};

template <int F>
struct MagnitudeProduct<int64_t, F> {
    static FIXEDPOINT_CONSTEXPR uint64_t apply(uint64_t a, uint64_t b) {
        const portable::Wide128 product = portable::multiply_full(a, b);
        return F == 0 ? product.low : (product.high << (63 - (F - 1))) | (product.low >> F);
    }
};

// Both operands are made positive, multiplied in twice the width, shifted right, and the sign is
// restored. Corrected: the most negative number, whose negation overflowed, has a magnitude here.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw multiply(Raw a, Raw b) {
    int flip = 1;
    if (a < 0) {
        a = wrapping_negate(a);
        flip = -flip;
    }
    if (b < 0) {
        b = wrapping_negate(b);
        flip = -flip;
    }
    return flip_sign<Raw>(MagnitudeProduct<Raw, F>::apply(static_cast<Unsigned<Raw>>(a),
                                                          static_cast<Unsigned<Raw>>(b)),
                          flip);
}

}  // namespace published
}  // namespace fixedpoint
