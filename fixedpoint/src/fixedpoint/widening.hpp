// SPDX-License-Identifier: MIT
/// \file
/// Exact sums and products, in a format wide enough for all of them, and the way back to a narrower
/// format.
///
///   Fixed<32, 32> energy = widening_multiply(force, way);  // of two Q16.16
///   Q16_16 mean = narrow<Q16_16>(widening_add(a, b) / 2);
#pragma once

#include <fixedpoint/conversion.hpp>

namespace fixedpoint {

/// \cond internal
// The narrowest width of at least that many bits.
template <int Bits>
struct WidthOf {
    static_assert(
        Bits <= 64,
        "No format holds this sum or product: the operands of a product must have at most "
        "64 bits together, those of a sum 32 bits each.");
    static constexpr int value = Bits <= 8 ? 8 : Bits <= 16 ? 16 : Bits <= 32 ? 32 : 64;
};
/// \endcond

/// a b, exact. The result has the fraction bits of both operands and the narrowest of the widths
/// 16, 32 and 64 that both fit into together. Products of more than 64 bits do not compile.
template <int IntegerBits1, int F1, int IntegerBits2, int F2, class A>
constexpr Fixed<WidthOf<IntegerBits1 + F1 + IntegerBits2 + F2>::value - F1 - F2, F1 + F2, A>
widening_multiply(Fixed<IntegerBits1, F1, A> a, Fixed<IntegerBits2, F2, A> b) {
    using Product =
        Fixed<WidthOf<IntegerBits1 + F1 + IntegerBits2 + F2>::value - F1 - F2, F1 + F2, A>;
    using Raw = typename Product::Raw;
    return Product::from_raw(
        static_cast<Raw>(static_cast<Raw>(a.raw()) * static_cast<Raw>(b.raw())));
}

/// a + b, exact. The result has twice the width and the same fraction bits. Sums of two 64-bit
/// numbers do not compile.
template <int IntegerBits, int F, class A>
constexpr Fixed<WidthOf<2 * (IntegerBits + F)>::value - F, F, A> widening_add(
    Fixed<IntegerBits, F, A> a, Fixed<IntegerBits, F, A> b) {
    using Sum = Fixed<WidthOf<2 * (IntegerBits + F)>::value - F, F, A>;
    using Raw = typename Sum::Raw;
    return Sum::from_raw(static_cast<Raw>(static_cast<Raw>(a.raw()) + static_cast<Raw>(b.raw())));
}

/// x in To, a fixed-point or an integer type: rounded once, to nearest, half up, and saturated in
/// every arithmetic. Checked does not notify its hook of saturation here; convert does.
template <class To, int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR To narrow(Fixed<IntegerBits, F, A> x) {
    return convert_checked<To>(x).number;
}

}  // namespace fixedpoint
