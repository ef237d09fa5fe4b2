// SPDX-License-Identifier: MIT
/// \file
/// Angles in turns and in degrees, and a type that is one. A number's fraction of a turn is its
/// angle, so that no angle is too large: sines are exact at every quarter turn, in the range of the
/// format and beyond.
#pragma once

#include <fixedpoint/kernel/turns.hpp>
#include <fixedpoint/math.hpp>

namespace fixedpoint {

/// \cond internal
template <class Number>
using CoreOf = kernel::SineOfPhase<typename Number::Raw, Number::fraction_bits>;
template <class Number>
FIXEDPOINT_CONSTEXPR Number sine_of_phase(typename CoreOf<Number>::Phase phase) {
    return Number::from_raw(CoreOf<Number>::sine(phase));
}
template <class Number>
FIXEDPOINT_CONSTEXPR Number cosine_of_phase(typename CoreOf<Number>::Phase phase) {
    return sine_of_phase<Number>(static_cast<typename CoreOf<Number>::Phase>(
        phase + kernel::quarter_turn<CoreOf<Number>>()));
}
template <class Number>
FIXEDPOINT_CONSTEXPR SineAndCosine<Number> sine_and_cosine_of_phase(
    typename CoreOf<Number>::Phase phase) {
    return {sine_of_phase<Number>(phase), cosine_of_phase<Number>(phase)};
}
template <class Number>
constexpr typename CoreOf<Number>::Phase turns_phase(Number angle) {
    return kernel::phase_of_turns<CoreOf<Number>, typename Number::Raw, Number::fraction_bits>(
        angle.raw());
}
template <class Number>
constexpr typename CoreOf<Number>::Phase degrees_phase(Number angle) {
    return kernel::phase_of_degrees<CoreOf<Number>, typename Number::Raw, Number::fraction_bits>(
        angle.raw());
}
template <class Number>
using AngleOfVector = kernel::AngleOfVector<typename Number::Raw, Number::fraction_bits>;
/// \endcond

/// The sine of any angle in turns, faithful (error below 0.75 ulp), never beyond -1 and 1; exact at
/// whole numbers of quarter turns, saturated where the format does not hold 1.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR Fixed<IntegerBits, F, A> sin_turns(Fixed<IntegerBits, F, A> angle) {
    return sine_of_phase<Fixed<IntegerBits, F, A>>(turns_phase(angle));
}
/// The cosine of any angle in turns, as sin_turns.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR Fixed<IntegerBits, F, A> cos_turns(Fixed<IntegerBits, F, A> angle) {
    return cosine_of_phase<Fixed<IntegerBits, F, A>>(turns_phase(angle));
}
/// Sine and cosine of any angle in turns, each as sin_turns.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR SineAndCosine<Fixed<IntegerBits, F, A>> sincos_turns(
    Fixed<IntegerBits, F, A> angle) {
    return sine_and_cosine_of_phase<Fixed<IntegerBits, F, A>>(turns_phase(angle));
}
/// The angle of the vector (x, y) in turns, from -1/2 to 1/2, faithful (error below 0.75 ulp, with
/// 63 fraction bits below 1 ulp); exact on the axes, and 0 where both are 0.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR Fixed<IntegerBits, F, A> atan2_turns(Fixed<IntegerBits, F, A> y,
                                                          Fixed<IntegerBits, F, A> x) {
    using Number = Fixed<IntegerBits, F, A>;
    return Number::from_raw(AngleOfVector<Number>::in_turns(y.raw(), x.raw()));
}

/// The sine of any angle in degrees, faithful (error below 0.75 ulp), never beyond -1 and 1; exact
/// at multiples of 90, saturated where the format does not hold 1. More than 54 fraction bits do
/// not compile. A division makes turns of degrees: turns are cheaper.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR Fixed<IntegerBits, F, A> sin_degrees(Fixed<IntegerBits, F, A> angle) {
    return sine_of_phase<Fixed<IntegerBits, F, A>>(degrees_phase(angle));
}
/// The cosine of any angle in degrees, as sin_degrees.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR Fixed<IntegerBits, F, A> cos_degrees(Fixed<IntegerBits, F, A> angle) {
    return cosine_of_phase<Fixed<IntegerBits, F, A>>(degrees_phase(angle));
}
/// Sine and cosine of any angle in degrees, each as sin_degrees.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR SineAndCosine<Fixed<IntegerBits, F, A>> sincos_degrees(
    Fixed<IntegerBits, F, A> angle) {
    return sine_and_cosine_of_phase<Fixed<IntegerBits, F, A>>(degrees_phase(angle));
}
/// The angle of the vector (x, y) in degrees, from -180 to 180, faithful (error below 0.75 ulp),
/// saturated; exact on the axes, and 0 where both are 0. More than 54 fraction bits do not compile.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR Fixed<IntegerBits, F, A> atan2_degrees(Fixed<IntegerBits, F, A> y,
                                                            Fixed<IntegerBits, F, A> x) {
    using Number = Fixed<IntegerBits, F, A>;
    return Number::from_raw(AngleOfVector<Number>::in_degrees(y.raw(), x.raw()));
}

/// An angle: raw / 2^Bits of a turn, with Bits = 16 or 32. What lies beyond a turn wraps around, as
/// angles do.
template <int Bits>
class Turn {
    static_assert(Bits == 16 || Bits == 32, "A turn has 16 or 32 bits.");

  public:
    /// The unsigned integer of Bits bits.
    using Raw = UnsignedInteger<Bits>;

    /// The angle 0.
    constexpr Turn() : raw_(0) {}
    /// The angle of raw / 2^Bits turns.
    static constexpr Turn from_raw(Raw raw) { return Turn(raw); }
    /// The angle in 2^-Bits turns.
    constexpr Raw raw() const { return raw_; }

    /// The angle of so many turns, rounded to nearest, half up.
    template <int IntegerBits, int F, class A>
    static constexpr Turn from_turns(Fixed<IntegerBits, F, A> turns) {
        return Turn(portable::convert<Raw, Bits, Integer<IntegerBits + F>, F>(turns.raw()));
    }
    /// The angle in turns, in [-1/2, 1/2), rounded to nearest, half up, as the arithmetic of Number
    /// converts.
    template <class Number>
    constexpr Number turns() const {
        return Number::from_raw(
            Number::Arithmetic::template convert<typename Number::Raw, Number::fraction_bits,
                                                 Integer<Bits>, Bits>(
                static_cast<Integer<Bits>>(raw_)));
    }

    /// The sum, the difference, the opposite and the multiple, each less its whole turns.
    /// @{
    friend constexpr Turn operator+(Turn a, Turn b) {
        return Turn(static_cast<Raw>(a.raw_ + b.raw_));
    }
    friend constexpr Turn operator-(Turn a, Turn b) {
        return Turn(static_cast<Raw>(a.raw_ - b.raw_));
    }
    constexpr Turn operator-() const { return Turn(static_cast<Raw>(0 - raw_)); }
    template <class Int>
    friend constexpr typename BesideInteger<Int, Turn>::Type operator*(Turn a, Int n) {
        return Turn(
            static_cast<Raw>(portable::multiply_integer(static_cast<Integer<Bits>>(a.raw_), n)));
    }
    template <class Int>
    friend constexpr typename BesideInteger<Int, Turn>::Type operator*(Int n, Turn a) {
        return a * n;
    }
    FIXEDPOINT_CONSTEXPR Turn& operator+=(Turn b) { return *this = *this + b; }
    FIXEDPOINT_CONSTEXPR Turn& operator-=(Turn b) { return *this = *this - b; }
    /// @}
    /// Whether the two are the same angle. Angles on a circle have no order.
    /// @{
    friend constexpr bool operator==(Turn a, Turn b) { return a.raw_ == b.raw_; }
    friend constexpr bool operator!=(Turn a, Turn b) { return a.raw_ != b.raw_; }
    /// @}

    /// \cond internal
    // The phase that a sine's core takes; bits that are too fine for it are cut.
    template <class Core>
    constexpr typename Core::Phase phase() const {
        return Core::phase_bits >= Bits
                   ? static_cast<typename Core::Phase>(
                         static_cast<typename Core::Phase>(raw_)
                         << (Core::phase_bits >= Bits ? Core::phase_bits - Bits : 0))
                   : static_cast<typename Core::Phase>(
                         raw_ >> (Core::phase_bits >= Bits ? 0 : Bits - Core::phase_bits));
    }
    /// \endcond

  private:
    constexpr explicit Turn(Raw raw) : raw_(raw) {}

    Raw raw_;
};

/// The sine of an angle as a number: sin<Q16_16>(angle), as sin_turns.
template <class Number, int Bits>
FIXEDPOINT_CONSTEXPR Number sin(Turn<Bits> angle) {
    return sine_of_phase<Number>(angle.template phase<CoreOf<Number>>());
}
/// The cosine of an angle as a number, as sin_turns.
template <class Number, int Bits>
FIXEDPOINT_CONSTEXPR Number cos(Turn<Bits> angle) {
    return cosine_of_phase<Number>(angle.template phase<CoreOf<Number>>());
}
/// Sine and cosine of an angle as numbers, each as sin_turns.
template <class Number, int Bits>
FIXEDPOINT_CONSTEXPR SineAndCosine<Number> sincos(Turn<Bits> angle) {
    return sine_and_cosine_of_phase<Number>(angle.template phase<CoreOf<Number>>());
}

}  // namespace fixedpoint
