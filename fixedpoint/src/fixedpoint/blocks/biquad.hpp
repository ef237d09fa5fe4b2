// SPDX-License-Identifier: MIT
/// \file
/// Biquad: a second-order filter in direct form I with error feedback.
///
/// Direct form I, since its states are inputs and outputs, which are in range whenever the signals
/// are; the states of direct form II are larger than both by the gain of the poles. Error feedback,
/// since the poles would otherwise amplify the rounding error of an output, at low frequencies by 1
/// / (1 + a1 + a2). The errors of the last two outputs are fed back with the integers nearest to
/// -a1 and -a2 as weights, which takes no multiplication and leaves almost nothing to amplify
/// (Laakso and Hartimo, "Noise reduction in recursive digital filters using high-order error
/// feedback", 1992).
#pragma once

#include <fixedpoint/blocks/carried_error.hpp>
#include <fixedpoint/blocks/filter_kernel.hpp>

namespace fixedpoint {

/// The coefficients of (b0 + b1 z^-1 + b2 z^-2) / (1 + a1 z^-1 + a2 z^-2), as filter design
/// programs print them.
template <class Number>
struct BiquadCoefficients {
    /// The coefficients of the inputs.
    /// @{
    Number b0, b1, b2;
    /// @}
    /// The coefficients of the outputs.
    /// @{
    Number a1, a2;
    /// @}
};

/// \cond internal
// The sum of the five products, for float and double.
template <class Number>
struct BiquadSum {
    constexpr BiquadSum(Number, Number) {}
    Number of(const Number* a, const Number* b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] + a[4] * b[4];
    }
};
// For Fixed: the sum of the five products and the fed-back errors of the last two sums, rounded
// once.
template <int IntegerBits, int F, class A>
class BiquadSum<Fixed<IntegerBits, F, A>> {
    static_assert(IntegerBits >= 3, "Biquad coefficients, which reach 2, need 3 integer bits.");

  public:
    using Number = Fixed<IntegerBits, F, A>;
    constexpr BiquadSum(Number feedback1, Number feedback2)
        : weight1_(nearest_integer(feedback1, 2)), weight2_(nearest_integer(feedback2, 1)) {}
    static constexpr int8_t nearest_integer(Number x, int8_t limit) {
        return convert<int8_t>(clamp(x, Number::from_integer(-limit), Number::from_integer(limit)));
    }
    Number of(const Number* a, const Number* b) {
        Sum error = static_cast<Sum>(times(weight1_, error1_) + times(weight2_, error2_));
        Number sum;
        if (A::is_modulo) {
            sum = dot3(a, b) + dot2(a + 3, b + 3);
            error = static_cast<Sum>(error +
                                     Rounding::of_sum(static_cast<typename Rounding::Low>(
                                         low(a[0], b[0]) + low(a[1], b[1]) + low(a[2], b[2]))) +
                                     Rounding::of_sum(static_cast<typename Rounding::Low>(
                                         low(a[3], b[3]) + low(a[4], b[4]))));
        } else {
            for (uint8_t i = 0; i < 5; ++i) {
                sum = multiply_add(a[i], b[i], sum);
                error = static_cast<Sum>(error + Rounding::of_product(a[i].raw(), b[i].raw()));
            }
        }
        error2_ = error1_;
        error1_ = Rounding::of_sum(error);
        return sum + Number::from_raw(static_cast<typename Number::Raw>(Rounding::ulps(error)));
    }

  private:
    using Rounding = RoundingError<F>;
    using Sum = typename Rounding::Sum;
    using Error = typename Rounding::Error;
    static typename Rounding::Low low(Number a, Number b) {
        return Rounding::low_product(a.raw(), b.raw());
    }
    // By cases, since the compiler would compute a 32-bit product in a loop.
    static Sum times(int8_t weight, Error error) {
        if (weight == 0) return 0;
        const Sum sum = static_cast<Sum>(weight & 1 ? Sum(error) : Sum(error) * 2);
        return static_cast<Sum>(weight < 0 ? -sum : sum);
    }

    int8_t weight1_, weight2_;
    Error error1_ = 0, error2_ = 0;
};
// The state of a filter, and one step.
template <class Number, bool in_kernel = FilterKernel<Number>::exists>
class BiquadSteps {
  public:
    explicit constexpr BiquadSteps(const BiquadCoefficients<Number>& c)
        : coefficient_{c.b0, c.b1, c.b2, -c.a1, -c.a2}, state_(), sum_(-c.a1, -c.a2) {}
    Number take(Number input) {
        state_[2] = state_[1];
        state_[1] = state_[0];
        state_[0] = input;
        const Number output = sum_.of(coefficient_, state_);
        state_[4] = state_[3];
        state_[3] = output;
        return output;
    }

  private:
    Number coefficient_[5];
    // x, x1, x2, y1, y2.
    Number state_[5];
    BiquadSum<Number> sum_;
};
// The members are in the order that the kernel expects.
template <class Number>
class BiquadSteps<Number, true> {
  public:
    explicit constexpr BiquadSteps(const BiquadCoefficients<Number>& c)
        : coefficient_{c.b0, c.b1, c.b2, -c.a1, -c.a2},
          state_(),
          weight_{BiquadSum<Number>::nearest_integer(-c.a1, 2),
                  BiquadSum<Number>::nearest_integer(-c.a2, 1)},
          error_() {}
    Number take(Number input) { return FilterKernel<Number>::biquad(input, this); }

  private:
    Number coefficient_[5];
    // x1, x2, y1, y2.
    Number state_[4];
    int8_t weight_[2];
    typename RoundingError<Number::fraction_bits>::Error error_[2];
};
// The same for the kernel of Q8.24. A sum of seven bytes is an output with its error, plus half an
// ulp.
template <>
class BiquadSteps<Fixed<8, 24>, true> {
    using Number = Fixed<8, 24>;

  public:
    explicit constexpr BiquadSteps(const BiquadCoefficients<Number>& c)
        : state_{c.b0,
                 (1 - nearest_integer(-c.a1, 2) - nearest_integer(-c.a2, 1)) * 128,
                 c.b1,
                 Number(),
                 c.b2,
                 Number(),
                 -c.a2,
                 {0, 0, 0x80},
                 -c.a1,
                 {0, 0, 0x80},
                 nearest_integer(-c.a2, 1),
                 nearest_integer(-c.a1, 2)} {}
    Number take(Number input) { return FilterKernel<Number>::biquad(input, &state_); }

  private:
    struct State {
        Number b0;
        int32_t halves;
        Number b1, x1, b2, x2, c2;
        uint8_t sum2[7];
        Number c1;
        uint8_t sum1[7];
        int8_t weight2, weight1;
    };
    static_assert(!kernel::has_assembly || sizeof(State) == 48,
                  "The layout must be that of avr/biquad_q8_24.S.");

    // That of BiquadSum, in a fraction of its flash.
    static constexpr int8_t nearest_integer(Number x, int8_t limit) {
        return limited(static_cast<int8_t>(x.raw() >> 24), x.raw() >> 23 & 1, limit);
    }
    static constexpr int8_t limited(int8_t whole, bool half, int8_t limit) {
        return static_cast<int8_t>(whole >= limit ? limit : whole < -limit ? -limit : whole + half);
    }

    State state_;
};
/// \endcond

/// The filter y = b0 x + b1 x1 + b2 x2 - a1 y1 - a2 y2.
///
/// For every input, the exact sum, including the errors fed back, is rounded once. In a wrapping
/// arithmetic partial sums may overflow. An output out of range is taken modulo 2^W, from which a
/// filter may never recover; with Fixed<I, F, Saturating> it saturates, and so do the partial sums.
/// The output of a stable filter is within 1/2 sum |g_n| ulp of the exact filter's; with zero input
/// it settles at 0 or in a limit cycle of that size. g is the impulse response of (1 + k1 z^-1 + k2
/// z^-2) / (1 + a1 z^-1 + a2 z^-2), where k1 and k2 are the integers nearest to a1 and a2. For the
/// low-pass filter with a1 = -1.758, a2 = 0.836 the bound is 1.8 ulp; without feedback it is 14
/// ulp.
template <class Number>
class Biquad {
  public:
    /// At rest: all previous inputs and outputs are 0.
    explicit constexpr Biquad(const BiquadCoefficients<Number>& c) : steps_(c) {}

    /// Takes the next input and returns the output.
    Number update(Number input) { return steps_.take(input); }

  private:
    BiquadSteps<Number> steps_;
};

}  // namespace fixedpoint
