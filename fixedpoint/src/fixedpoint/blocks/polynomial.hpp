// SPDX-License-Identifier: MIT
/// \file
/// polynomial: Horner's rule in a format finer than that of the argument and the result, so that
/// only the final rounding matters.
#pragma once

#include <fixedpoint/blocks/number.hpp>
#include <fixedpoint/blocks/table.hpp>

namespace fixedpoint {

/// \cond internal
// For x in any 32-bit format.
template <int F>
struct PolynomialKernel;
#define FIXEDPOINT_POLYNOMIAL_KERNEL(KERNEL, shape, name, I, F)                                   \
    extern "C" int32_t fixedpoint_polynomial_q##I##_##F(int32_t x, const int32_t* c, uint16_t n); \
    template <>                                                                                   \
    struct PolynomialKernel<F> {                                                                  \
        static int32_t apply(int32_t x, const int32_t* c, uint16_t n) {                           \
            return fixedpoint_polynomial_q##I##_##F(x, c, n);                                     \
        }                                                                                         \
    };
FIXEDPOINT_POLYNOMIAL_KERNEL(, , , 16, 16)
FIXEDPOINT_SPLITS_32(FIXEDPOINT_POLYNOMIAL_KERNEL, , , )
#undef FIXEDPOINT_POLYNOMIAL_KERNEL

// c + x p, rounded once to the format of c and p.
template <class Number, class Coefficient>
struct HornerStep {
    explicit HornerStep(Number x) : x_(BlockNumber<Coefficient>::from(x)) {}
    Coefficient apply(Coefficient p, Coefficient c) const {
        return BlockNumber<Coefficient>::multiply_add(p, x_, c);
    }

  private:
    Coefficient x_;
};
// The product of two raws, shifted right by the fraction bits of x, has the format of p: x need not
// be converted. In 32 bits every such product has a kernel.
template <int IntegerBits, int F, class A, int CoefficientF>
struct HornerStep<Fixed<IntegerBits, F, A>, Fixed<32 - CoefficientF, CoefficientF, A>> {
    static_assert(IntegerBits + F <= 32, "Coefficients must be at least as wide as the argument.");
    using Coefficient = Fixed<32 - CoefficientF, CoefficientF, A>;
    explicit HornerStep(Fixed<IntegerBits, F, A> x) : x_(x.raw()) {}
    Coefficient apply(Coefficient p, Coefficient c) const {
        return Coefficient::from_raw(A::template multiply_add<int32_t, F>(p.raw(), x_, c.raw()));
    }

  private:
    int32_t x_;
};
template <class Number, class Coefficient, bool in_kernel>
struct Horner {
    template <uint16_t N>
    static Coefficient apply(Number x, const Table<Coefficient, N>& coefficient) {
        const HornerStep<Number, Coefficient> step(x);
        Coefficient sum = coefficient[N - 1];
        for (uint16_t i = N - 1; i-- != 0;) sum = step.apply(sum, coefficient[i]);
        return sum;
    }
};
// In one call, if every x is a number of Q16.16 or x has 32 bits.
template <int IntegerBits, int F, int CoefficientF>
struct Horner<Fixed<IntegerBits, F>, Fixed<32 - CoefficientF, CoefficientF>, true> {
    using Coefficient = Fixed<32 - CoefficientF, CoefficientF>;
    template <uint16_t N>
    static Coefficient apply(Fixed<IntegerBits, F> x, const Table<Coefficient, N>& coefficient) {
        constexpr int kernel_bits = IntegerBits <= 16 && F <= 16 ? 16 : F;
        return Coefficient::from_raw(PolynomialKernel<kernel_bits>::apply(
            convert<Fixed<32 - kernel_bits, kernel_bits>>(x).raw(), raws(coefficient.entry), N));
    }
};
template <class Number, class Coefficient>
struct HornerInKernel {
    static constexpr bool value = false;
};
template <int IntegerBits, int F, int CoefficientF>
struct HornerInKernel<Fixed<IntegerBits, F>, Fixed<32 - CoefficientF, CoefficientF>> {
    static constexpr bool value =
        kernel::has_assembly && ((IntegerBits <= 16 && F <= 16) || IntegerBits + F == 32);
};
/// \endcond

/// The sum of coefficient[i] x^i, computed in the format of the coefficients and rounded to that of
/// x.
///
/// Let W be the format of the coefficients. Each of the N - 1 steps c + x p is rounded once. For
/// |x| <= 1 the error is therefore at most 1/2 ulp of the result plus (N - 1)/2 ulp of W: below
/// 0.52 ulp up to degree 9 if W has 8 more fraction bits, as Q8.24 has compared with Q16.16, and
/// Q16.16 with Q8.8. If an intermediate result is out of the range of W, or the final one out of
/// the range of x, the arithmetic decides (Nearest: modulo 2^W). 32-bit coefficients are multiplied
/// by x itself, which must have at most 32 bits; others by x converted to W.
template <class Number, class Coefficient, uint16_t N>
Number polynomial(Number x, const Table<Coefficient, N>& coefficient) {
    return BlockNumber<Number>::from(
        Horner<Number, Coefficient, HornerInKernel<Number, Coefficient>::value>::apply(
            x, coefficient));
}

}  // namespace fixedpoint
