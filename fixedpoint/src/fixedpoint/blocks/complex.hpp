// SPDX-License-Identifier: MIT
/// \file
/// Complex numbers. Each part of a product is rounded once.
#pragma once

#include <fixedpoint/blocks/number.hpp>

namespace fixedpoint {

template <class Number>
struct Complex;

/// \cond internal
template <class Number>
struct ComplexProduct {
    static void apply(const Number* a, const Number* b, Number* result) {
        const Number conjugate[2] = {b[0], -b[1]}, swapped[2] = {b[1], b[0]};
        result[0] = BlockNumber<Number>::dot2(a, conjugate);
        result[1] = BlockNumber<Number>::dot2(a, swapped);
    }
};
// In one call of a kernel.
template <int F>
struct ComplexProduct<Fixed<32 - F, F>> {
    using Number = Fixed<32 - F, F>;
    static void apply(const Number* a, const Number* b, Number* result) {
        kernel::complex_product<int32_t, F>(raws(result), raws(a), raws(b));
    }
};
/// \endcond

/// The complex number part[0] + i part[1].
template <class Number>
struct Complex {
    /// The real and the imaginary part.
    Number part[2];

    /// The real part.
    constexpr Number real() const { return part[0]; }
    /// The imaginary part.
    constexpr Number imaginary() const { return part[1]; }

    /// The exact sum. If a part is out of range, the arithmetic decides.
    friend constexpr Complex operator+(const Complex& a, const Complex& b) {
        return {{a.part[0] + b.part[0], a.part[1] + b.part[1]}};
    }
    /// The exact difference. If a part is out of range, the arithmetic decides.
    friend constexpr Complex operator-(const Complex& a, const Complex& b) {
        return {{a.part[0] - b.part[0], a.part[1] - b.part[1]}};
    }
    /// The product, each part rounded once. If a part is out of range, the arithmetic decides. If
    /// the imaginary part of b is the smallest number, its negative in the real part is what the
    /// arithmetic makes of it; only the default arithmetic in 32 bits is exact there too.
    friend Complex operator*(const Complex& a, const Complex& b) {
        Complex product;
        multiply(a, b, product);
        return product;
    }
};

/// result = a b, without the copy of an assignment. `result` must not be `a` or `b`.
template <class Number>
void multiply(const Complex<Number>& a, const Complex<Number>& b, Complex<Number>& result) {
    ComplexProduct<Number>::apply(a.part, b.part, result.part);
}

/// The conjugate. If the imaginary part is the smallest number, the arithmetic decides on its
/// negative.
template <class Number>
constexpr Complex<Number> conjugate(const Complex<Number>& a) {
    return {{a.part[0], -a.part[1]}};
}
/// |a|^2, rounded once. If it is out of range, the arithmetic decides. The magnitude |a| is
/// length2(a.part), in which no square overflows.
template <class Number>
Number squared_magnitude(const Complex<Number>& a) {
    return BlockNumber<Number>::dot2(a.part, a.part);
}

}  // namespace fixedpoint
