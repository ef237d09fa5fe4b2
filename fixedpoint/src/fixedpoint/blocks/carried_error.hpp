// SPDX-License-Identifier: MIT
/// \file
/// CarriedError: sums of products whose rounding error is not lost but carried into the next sum.
/// An integrator or filter that computes its state this way follows the exact one: increments too
/// small for one step accumulate over many (error feedback, or fraction saving: Dattorro, "The
/// implementation of recursive digital filters for high-fidelity audio", 1988).
///
/// The error does not need a wide product: a b modulo 2^F depends only on the low F bits of a and
/// b, and the product rounded half up differs from the exact one by just these bits, read as a
/// signed number.
#pragma once

#include <fixedpoint/blocks/number.hpp>

namespace fixedpoint {

/// \cond internal
// The exact product of two numbers with F fraction bits less the product rounded half up: in [-1/2,
// 1/2) ulp, in units of 2^-F ulp.
template <int F>
struct RoundingError {
    static_assert(F <= 60, "Errors can be carried with up to 60 fraction bits.");
    // Low has at least F bits; Sum is signed and can hold the sum of 16 errors.
    using Low = UnsignedInteger<F <= 8 ? 8 : F <= 16 ? 16 : F <= 32 ? 32 : 64>;
    using Sum = Integer<F <= 4 ? 8 : F <= 12 ? 16 : F <= 28 ? 32 : 64>;
    using Error = Integer<RawLimits<Low>::width>;

    // a b modulo 2^F; higher bits are unspecified.
    template <class Raw>
    static constexpr Low low_product(Raw a, Raw b) {
        return static_cast<Low>(1u * static_cast<Low>(a) * static_cast<Low>(b));
    }
    template <class Raw>
    static constexpr Error of_product(Raw a, Raw b) {
        return of_sum(low_product(a, b));
    }
    // What remains of a sum of errors once its whole ulps are removed: the low F bits as a signed
    // number.
    template <class Int>
    static constexpr Error of_sum(Int sum) {
        return static_cast<Error>(
            static_cast<Error>(static_cast<Low>(static_cast<Low>(sum) << shift)) >> shift);
    }
    // The whole ulps in a sum of errors.
    static constexpr Sum ulps(Sum sum) { return static_cast<Sum>((sum - of_sum(sum)) >> F); }

    static constexpr unsigned char shift = RawLimits<Low>::width - F;
};
/// \endcond

/// For float and double: their rounding error is not known, so nothing is carried.
template <class Number>
class CarriedError {
  public:
    /// c + a b.
    Number multiply_add(Number a, Number b, Number c) { return a * b + c; }
};

/// The rounding error of the last sum, in [-1/2, 1/2) ulp; initially 0.
template <int IntegerBits, int F, class A>
class CarriedError<Fixed<IntegerBits, F, A>> {
  public:
    /// The type of the numbers summed.
    using Number = Fixed<IntegerBits, F, A>;

    /// c + a b + the carried error, rounded once. If it is out of range, the arithmetic decides.
    Number multiply_add(Number a, Number b, Number c) {
        const Low low = static_cast<Low>(RoundingError<F>::low_product(a.raw(), b.raw())
                                         << RoundingError<F>::shift);
        sum_ = static_cast<Low>(sum_ + low);
        // multiply_add rounds the product without the carried error.
        const bool carry = sum_ < low, rounded_up = low >> (RawLimits<Low>::width - 1) != 0;
        const auto missing = static_cast<int8_t>(carry - rounded_up);
        const Number sum = fixedpoint::multiply_add(a, b, c);
        return missing == 0 ? sum : sum + Number::from_raw(missing);
    }

  private:
    using Low = typename RoundingError<F>::Low;
    // The error plus 1/2 ulp, that is, the fraction of an ulp that truncation leaves, left-aligned.
    Low sum_ = static_cast<Low>(Low(1) << (RawLimits<Low>::width - 1));
};

}  // namespace fixedpoint
