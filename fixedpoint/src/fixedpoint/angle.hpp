// SPDX-License-Identifier: MIT
/// \file
/// Angles in turns and in degrees, and Turn, a type for an angle. Only the fractional part of a
/// number of turns matters, so no angle is too large, and sines are exact at every quarter turn.
#pragma once

#include <fixedpoint/kernel/turns.hpp>
#include <fixedpoint/math.hpp>

namespace fixedpoint {

/// \cond internal
template <class Number>
using CoreOf =
    kernel::SineOfPhase<typename Signed<typename Number::Raw>::Type, Number::fraction_bits>;
template <class Number>
using TurnsCoreOf = typename kernel::ShortPhase<CoreOf<Number>>::Type;
template <class Number, class Core = CoreOf<Number>>
FIXEDPOINT_IN_PLACE Number sine_of_phase(typename Core::Phase phase) {
    return Number::from_raw(Core::sine(phase));
}
template <class Number, class Core = CoreOf<Number>>
FIXEDPOINT_IN_PLACE Number cosine_of_phase(typename Core::Phase phase) {
    return sine_of_phase<Number, Core>(
        static_cast<typename Core::Phase>(phase + kernel::quarter_turn<Core>()));
}
template <class Number, class Core = CoreOf<Number>>
FIXEDPOINT_CONSTEXPR SineAndCosine<Number> sine_and_cosine_of_phase(typename Core::Phase phase) {
    return {sine_of_phase<Number, Core>(phase), cosine_of_phase<Number, Core>(phase)};
}
template <class Number>
constexpr typename TurnsCoreOf<Number>::Phase turns_phase(Number angle) {
    return kernel::phase_of_turns<TurnsCoreOf<Number>, typename Number::Raw, Number::fraction_bits>(
        angle.raw());
}
template <class Number>
constexpr typename CoreOf<Number>::Phase degrees_phase(Number angle) {
    return kernel::phase_of_degrees<CoreOf<Number>, typename Number::Raw, Number::fraction_bits>(
        angle.raw());
}
template <class Number>
using AngleOfVector =
    kernel::AngleOfVector<typename Signed<typename Number::Raw>::Type, Number::fraction_bits>;
/// \endcond

/// The sine of any angle in turns, faithful (error below 0.75 ulp), never outside [-1, 1]; exact at
/// multiples of a quarter turn, but saturated if the format cannot represent 1.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR Fixed<IntegerBits, F, A> sin_turns(Fixed<IntegerBits, F, A> angle) {
    using Number = Fixed<IntegerBits, F, A>;
    return sine_of_phase<Number, TurnsCoreOf<Number>>(turns_phase(angle));
}
/// The cosine of any angle in turns, with the properties of sin_turns.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR Fixed<IntegerBits, F, A> cos_turns(Fixed<IntegerBits, F, A> angle) {
    using Number = Fixed<IntegerBits, F, A>;
    return cosine_of_phase<Number, TurnsCoreOf<Number>>(turns_phase(angle));
}
/// The sine and the cosine of any angle in turns: what sin_turns and cos_turns return.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR SineAndCosine<Fixed<IntegerBits, F, A>> sincos_turns(
    Fixed<IntegerBits, F, A> angle) {
    using Number = Fixed<IntegerBits, F, A>;
    return sine_and_cosine_of_phase<Number, TurnsCoreOf<Number>>(turns_phase(angle));
}
/// The angle of the vector (x, y) in turns, from -1/2 to 1/2, faithful (error below 0.75 ulp; below
/// 1 ulp with 63 fraction bits); exact on the axes, and 0 if both are 0.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR Fixed<IntegerBits, F, A> atan2_turns(Fixed<IntegerBits, F, A> y,
                                                          Fixed<IntegerBits, F, A> x) {
    using Number = Fixed<IntegerBits, F, A>;
    return Number::from_raw(AngleOfVector<Number>::in_turns(y.raw(), x.raw()));
}

/// The sine of any angle in degrees; the format must not have more than 54 fraction bits. Faithful
/// (error below 0.75 ulp), never outside [-1, 1]; exact at multiples of 90, but saturated if the
/// format cannot represent 1. Degrees are first divided down to turns: sin_turns is cheaper.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR Fixed<IntegerBits, F, A> sin_degrees(Fixed<IntegerBits, F, A> angle) {
    return sine_of_phase<Fixed<IntegerBits, F, A>>(degrees_phase(angle));
}
/// The cosine of any angle in degrees, with the properties of sin_degrees.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR Fixed<IntegerBits, F, A> cos_degrees(Fixed<IntegerBits, F, A> angle) {
    return cosine_of_phase<Fixed<IntegerBits, F, A>>(degrees_phase(angle));
}
/// The sine and the cosine of any angle in degrees: what sin_degrees and cos_degrees return.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR SineAndCosine<Fixed<IntegerBits, F, A>> sincos_degrees(
    Fixed<IntegerBits, F, A> angle) {
    return sine_and_cosine_of_phase<Fixed<IntegerBits, F, A>>(degrees_phase(angle));
}
/// The angle of the vector (x, y) in degrees, from -180 to 180; the format must not have more than
/// 54 fraction bits. Faithful (error below 0.75 ulp), saturated; exact on the axes, and 0 if both
/// are 0.
template <int IntegerBits, int F, class A>
FIXEDPOINT_CONSTEXPR Fixed<IntegerBits, F, A> atan2_degrees(Fixed<IntegerBits, F, A> y,
                                                            Fixed<IntegerBits, F, A> x) {
    using Number = Fixed<IntegerBits, F, A>;
    return Number::from_raw(AngleOfVector<Number>::in_degrees(y.raw(), x.raw()));
}

/// An angle of raw / 2^Bits turns; Bits must be 16 or 32. Whole turns are dropped, as befits an
/// angle.
template <int Bits>
class Turn {
    static_assert(Bits == 16 || Bits == 32, "A Turn has 16 or 32 bits.");

  public:
    /// The unsigned integer of Bits bits.
    using Raw = UnsignedInteger<Bits>;

    /// The angle 0.
    constexpr Turn() : raw_(0) {}
    /// The angle of raw / 2^Bits turns.
    static constexpr Turn from_raw(Raw raw) { return Turn(raw); }
    /// The angle in 2^-Bits turns.
    constexpr Raw raw() const { return raw_; }

    /// The angle of that many turns, rounded to nearest, half up, less its whole turns.
    template <int IntegerBits, int F, class A>
    static constexpr Turn from_turns(Fixed<IntegerBits, F, A> turns) {
        return Turn(portable::convert<Raw, Bits, RawOf<IntegerBits + F, A>, F>(turns.raw()));
    }
    /// The angle in turns, in [-1/2, 1/2), converted to Number by its arithmetic (Nearest: rounded
    /// to nearest, half up).
    template <class Number>
    constexpr Number turns() const {
        return Number::from_raw(
            Number::Arithmetic::template convert<typename Number::Raw, Number::fraction_bits,
                                                 Integer<Bits>, Bits>(
                static_cast<Integer<Bits>>(raw_)));
    }

    /// The exact sum, difference, negative and integer multiple, each less its whole turns.
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
    /// Whether the two are the same angle. There is no operator<, since angles on a circle have no
    /// order.
    /// @{
    friend constexpr bool operator==(Turn a, Turn b) { return a.raw_ == b.raw_; }
    friend constexpr bool operator!=(Turn a, Turn b) { return a.raw_ != b.raw_; }
    /// @}

    /// \cond internal
    // The phase that the core of the sine takes; bits too fine for it are truncated.
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

/// The sine of an angle as a number, as in sin<Q16_16>(angle), with the properties of sin_turns.
template <class Number, int Bits>
FIXEDPOINT_CONSTEXPR Number sin(Turn<Bits> angle) {
    return sine_of_phase<Number>(angle.template phase<CoreOf<Number>>());
}
/// The cosine of an angle as a number, with the properties of sin_turns.
template <class Number, int Bits>
FIXEDPOINT_CONSTEXPR Number cos(Turn<Bits> angle) {
    return cosine_of_phase<Number>(angle.template phase<CoreOf<Number>>());
}
/// The sine and the cosine of an angle as numbers, with the properties of sin_turns.
template <class Number, int Bits>
FIXEDPOINT_CONSTEXPR SineAndCosine<Number> sincos(Turn<Bits> angle) {
    return sine_and_cosine_of_phase<Number>(angle.template phase<CoreOf<Number>>());
}

}  // namespace fixedpoint
