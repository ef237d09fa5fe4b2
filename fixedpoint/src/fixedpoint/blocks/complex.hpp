// SPDX-License-Identifier: MIT
/// \file
/// Complex numbers, whose products round once.
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
// By one call of a kernel.
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

    /// The part without i.
    constexpr Number real() const { return part[0]; }
    /// The part before i.
    constexpr Number imaginary() const { return part[1]; }

    /// The sum, exact; out of the range as the arithmetic has it.
    friend constexpr Complex operator+(const Complex& a, const Complex& b) {
        return {{a.part[0] + b.part[0], a.part[1] + b.part[1]}};
    }
    /// The difference, exact; out of the range as the arithmetic has it.
    friend constexpr Complex operator-(const Complex& a, const Complex& b) {
        return {{a.part[0] - b.part[0], a.part[1] - b.part[1]}};
    }
    /// The product, each part rounded once; out of the range as the arithmetic has it. Where the
    /// imaginary part of b is the smallest number, its negative is that of the arithmetic, but for
    /// the default one in 32 bits, which is exact there, too.
    friend Complex operator*(const Complex& a, const Complex& b) {
        Complex product;
        multiply(a, b, product);
        return product;
    }
};

/// result = a b, which saves the copy of an assignment. `result` must be neither factor.
template <class Number>
void multiply(const Complex<Number>& a, const Complex<Number>& b, Complex<Number>& result) {
    ComplexProduct<Number>::apply(a.part, b.part, result.part);
}

/// The conjugate; the negative of the smallest number as the arithmetic has it.
template <class Number>
constexpr Complex<Number> conjugate(const Complex<Number>& a) {
    return {{a.part[0], -a.part[1]}};
}
/// |a|^2, rounded once; out of the range as the arithmetic has it. The magnitude |a| is
/// length2(a.part), which no square overflows.
template <class Number>
Number squared_magnitude(const Complex<Number>& a) {
    return BlockNumber<Number>::dot2(a.part, a.part);
}

}  // namespace fixedpoint
