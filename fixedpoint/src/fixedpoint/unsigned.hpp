// SPDX-License-Identifier: MIT
/// \file
/// UFixed<IntegerBits, FractionBits, Arithmetic>: a fixed-point number without a sign, value = raw
/// / 2^F, in an unsigned integer of IntegerBits + FractionBits = 8, 16, 32 or 64 bits. IntegerBits
/// may be 0: UFixed<0, 16> is a fraction in [0, 1).
///
/// It is Fixed over an unsigned raw, so operators, conversions and text are those of Fixed, under
/// the same rule: the exact result is rounded to nearest, half up; ring operations are then taken
/// modulo 2^W, and everything else saturates to [0, max]. A difference below 0 therefore wraps
/// modulo 2^W, as those of unsigned integers do. Saturating makes it 0 and Checked reports it;
/// abs_diff and a conversion to Fixed before the subtraction do without it.
///
/// Functions whose results have a sign, or whose arguments usually have one (sin, exp, log, powers,
/// lengths), do not compile: convert the argument, as in sin(convert<Q16_16>(x)).
#pragma once

#include <fixedpoint/conversion.hpp>
#include <fixedpoint/fixed.hpp>
#include <fixedpoint/literals.hpp>

namespace fixedpoint {

/// \cond internal
struct Saturating;
template <class Hook>
struct Checked;
template <class Arithmetic>
struct HasUnsigned {
    static constexpr bool value = false;
};
template <>
struct HasUnsigned<Nearest> {
    static constexpr bool value = true;
};
template <>
struct HasUnsigned<Saturating> {
    static constexpr bool value = true;
};
template <class Hook>
struct HasUnsigned<Checked<Hook>> {
    static constexpr bool value = true;
};
/// \endcond

/// The arithmetic Policy on numbers without a sign.
template <class Policy>
struct UnsignedArithmetic : Policy {};

/// \cond internal
template <int Bits, class Policy>
struct RawTypeOf<Bits, UnsignedArithmetic<Policy>> {
    static_assert(Bits != 24, "A number without a sign has 8, 16, 32 or 64 bits.");
    static_assert(HasUnsigned<Policy>::value,
                  "Unsigned numbers have the arithmetics Nearest, Saturating and Checked.");
    static constexpr bool is_signed = false;
    using Type = UnsignedInteger<Bits>;
};
/// \endcond

/// A number raw / 2^FractionBits, not negative. Policy is Nearest, Saturating or Checked<Hook>.
template <int IntegerBits, int FractionBits, class Policy = Nearest>
using UFixed = Fixed<IntegerBits, FractionBits, UnsignedArithmetic<Policy>>;

/// The constant x, an integer, float or double, as fixed<...>(x) has it: ufixed<0, 16>(0.38).
template <int IntegerBits, int FractionBits, class Policy = Nearest, class Number>
FIXEDPOINT_CONSTEVAL UFixed<IntegerBits, FractionBits, Policy> ufixed(Number x) {
    return fixed<IntegerBits, FractionBits, UnsignedArithmetic<Policy>>(x);
}

/// 8 bits: 0 to 15.9375 in steps of 0.0625.
using U4_4 = UFixed<4, 4>;
/// 16 bits: 0 to 255.996 in steps of 0.0039.
using U8_8 = UFixed<8, 8>;
/// 32 bits: 0 to 65535.99998 in steps of 0.000015.
using U16_16 = UFixed<16, 16>;
/// 64 bits: 0 to 2^32 in steps of 2.3e-10.
using U32_32 = UFixed<32, 32>;

namespace literals {

/// The number rounded to nearest, half up. Anything but a decimal number in the range of U4_4 does
/// not compile.
template <char... Text>
constexpr U4_4 operator""_u4_4() {
    return literal<U4_4, Text...>();
}
/// The number rounded to nearest, half up. Anything but a decimal number in the range of U8_8 does
/// not compile.
template <char... Text>
constexpr U8_8 operator""_u8_8() {
    return literal<U8_8, Text...>();
}
/// The number rounded to nearest, half up. Anything but a decimal number in the range of U16_16
/// does not compile.
template <char... Text>
constexpr U16_16 operator""_u16_16() {
    return literal<U16_16, Text...>();
}
/// The number rounded to nearest, half up. Anything but a decimal number in the range of U32_32
/// does not compile.
template <char... Text>
constexpr U32_32 operator""_u32_32() {
    return literal<U32_32, Text...>();
}

}  // namespace literals
}  // namespace fixedpoint
