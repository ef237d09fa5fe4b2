// SPDX-License-Identifier: MIT
// The integers behind fixed-point numbers: the two's-complement Integer<Bits>, their unsigned
// counterparts, the integer of twice the width, and the few wrapping operations and shifts that C++
// leaves undefined. A Raw has a sign or none; what depends on that asks RawLimits. Includes only
// <stdint.h>, so that it compiles for the chip.
#pragma once

#include <stdint.h>

#include <fixedpoint/constexpr.hpp>
#include <fixedpoint/int24.hpp>

// Macros of the Arduino core and of Windows that would break every function of these names,
// including the library's. Integers and floats keep abs and round from <stdlib.h> and <math.h>.
#undef abs
#undef max
#undef min
#undef round

namespace fixedpoint {

template <int Bits>
struct IntegerOf {
    static_assert(
        Bits == 8 || Bits == 16 || Bits == 24 || Bits == 32 || Bits == 64,
        "A fixed-point number has 8, 16, 24, 32 or 64 bits: choose IntegerBits + FractionBits "
        "accordingly.");
};
template <>
struct IntegerOf<8> {
    using Signed = int8_t;
    using Unsigned = uint8_t;
};
template <>
struct IntegerOf<16> {
    using Signed = int16_t;
    using Unsigned = uint16_t;
};
template <>
struct IntegerOf<24> {
    using Signed = Int24;
    using Unsigned = UnsignedInt24;
};
template <>
struct IntegerOf<32> {
    using Signed = int32_t;
    using Unsigned = uint32_t;
};
template <>
struct IntegerOf<64> {
    using Signed = int64_t;
    using Unsigned = uint64_t;
};

template <int Bits>
using Integer = typename IntegerOf<Bits>::Signed;
template <int Bits>
using UnsignedInteger = typename IntegerOf<Bits>::Unsigned;

// The bits of a Raw, whether it has a sign, and its largest and smallest value.
template <class Raw>
struct RawLimits {
    static constexpr int width = static_cast<int>(8 * sizeof(Raw));
    static constexpr bool is_signed = static_cast<Raw>(-1) < static_cast<Raw>(1);
    static constexpr Raw max =
        static_cast<Raw>(static_cast<UnsignedInteger<width>>(-1) >> (is_signed ? 1 : 0));
    static constexpr Raw min = static_cast<Raw>(is_signed ? -max - 1 : 0);
};
template <class Raw>
constexpr int RawLimits<Raw>::width;
template <class Raw>
constexpr bool RawLimits<Raw>::is_signed;
template <class Raw>
constexpr Raw RawLimits<Raw>::max;
template <class Raw>
constexpr Raw RawLimits<Raw>::min;

template <class Raw>
using Unsigned = UnsignedInteger<RawLimits<Raw>::width>;

template <int Bits, bool is_signed>
struct IntegerWithSign {
    using Type = Integer<Bits>;
};
template <int Bits>
struct IntegerWithSign<Bits, false> {
    using Type = UnsignedInteger<Bits>;
};
// The narrowest integer of at least twice the width, with a sign if Raw has one.
template <class Raw>
using Wide = typename IntegerWithSign<RawLimits<Raw>::width == 24 ? 64 : 2 * RawLimits<Raw>::width,
                                      RawLimits<Raw>::is_signed>::Type;

// a 2^count modulo 2^W. Requires count < W.
template <class Word>
constexpr Word shifted_left(Word a, unsigned char count) {
    return static_cast<Word>(a << count);
}
#ifdef FIXEDPOINT_HAS_INT24
// avr-gcc 5.4 shifts by 16 bits into other registers wrongly: it reads the lowest byte of the
// result in place of that of the operand.
inline UnsignedInt24 shifted_left_16(UnsignedInt24 a) {
    asm("mov %C0, %A0\n\tclr %B0\n\tclr %A0" : "+r"(a));
    return a;
}
template <>
constexpr UnsignedInt24 shifted_left(UnsignedInt24 a, unsigned char count) {
    return count == 16 && !__builtin_constant_p(a) ? shifted_left_16(a)
                                                   : static_cast<UnsignedInt24>(a << count);
}
#endif
// a b modulo 2^W.
template <class Word>
constexpr Word wrapping_product(Word a, Word b) {
    // The factor 1u keeps 16 bits from being multiplied as a signed int.
    return static_cast<Word>(1u * a * b);
}
#ifdef FIXEDPOINT_HAS_INT24
// A product with a constant 2^16 would become that shift.
constexpr UnsignedInt24 product_in_parts(UnsignedInt24 a, UnsignedInt24 constant) {
    return static_cast<UnsignedInt24>(
        a * static_cast<uint16_t>(constant) +
        shifted_left(static_cast<UnsignedInt24>(a * static_cast<uint8_t>(constant >> 16)), 16));
}
template <>
constexpr UnsignedInt24 wrapping_product(UnsignedInt24 a, UnsignedInt24 b) {
    return __builtin_constant_p(a) == __builtin_constant_p(b) ? static_cast<UnsignedInt24>(a * b)
           : __builtin_constant_p(b)                          ? product_in_parts(a, b)
                                                              : product_in_parts(b, a);
}
#endif

// a 2^count modulo 2^W, and a / 2^count rounded downward, for a constant count from 0 to W. C++
// leaves a shift by W undefined.
template <int count, class Raw>
constexpr Raw shift_up(Raw a) {
    return count >= RawLimits<Raw>::width
               ? Raw(0)
               : static_cast<Raw>(shifted_left(static_cast<Unsigned<Raw>>(a),
                                               count < RawLimits<Raw>::width ? count : 0));
}
template <int count, class Raw>
constexpr Raw shift_down(Raw a) {
    return count >= RawLimits<Raw>::width
               ? static_cast<Raw>(a < Raw(1) && a != Raw(0) ? -1 : 0)
               : static_cast<Raw>(a >> (count < RawLimits<Raw>::width ? count : 0));
}

// The raw of a number of that many bits in an arithmetic, which may say that it has no sign.
template <int Bits, class Arithmetic>
struct RawTypeOf {
    static constexpr bool is_signed = true;
    using Type = Integer<Bits>;
};
template <int Bits, class Arithmetic>
using RawOf = typename RawTypeOf<Bits, Arithmetic>::Type;
// The same for functions that need a sign.
template <class Raw, bool is_signed = RawLimits<Raw>::is_signed>
struct Signed {
    static_assert(is_signed,
                  "This function is for numbers with a sign: convert the argument first, as in "
                  "sin(convert<Q16_16>(x)).");
    using Type = Raw;
};
template <int Bits, class Arithmetic>
using SignedRawOf = typename Signed<RawOf<Bits, Arithmetic>>::Type;

// a + b, a - b, -a modulo 2^W.
template <class Raw>
constexpr Raw wrapping_add(Raw a, Raw b) {
    return static_cast<Raw>(
        static_cast<Unsigned<Raw>>(static_cast<Unsigned<Raw>>(a) + static_cast<Unsigned<Raw>>(b)));
}
template <class Raw>
constexpr Raw wrapping_subtract(Raw a, Raw b) {
    return static_cast<Raw>(
        static_cast<Unsigned<Raw>>(static_cast<Unsigned<Raw>>(a) - static_cast<Unsigned<Raw>>(b)));
}
template <class Raw>
constexpr Raw wrapping_negate(Raw a) {
    return wrapping_subtract(Raw(0), a);
}

// a 2^count modulo 2^W; 0 from count = W on.
template <class Raw>
constexpr Raw wrapping_shift_left(Raw a, unsigned char count) {
    return count >= RawLimits<Raw>::width
               ? Raw(0)
               : static_cast<Raw>(shifted_left(static_cast<Unsigned<Raw>>(a), count));
}

// |a| as an unsigned number, exact even for the smallest value.
template <class Raw>
constexpr Unsigned<Raw> magnitude(Raw a) {
    return a < 0 ? static_cast<Unsigned<Raw>>(Unsigned<Raw>(0) - static_cast<Unsigned<Raw>>(a))
                 : static_cast<Unsigned<Raw>>(a);
}

// Whether exactly one of the two is negative. Only the highest bytes are examined: the compiler for
// the chip would compare all of them.
template <class Raw>
constexpr bool signs_differ(Raw a, Raw b) {
    return RawLimits<Raw>::is_signed &&
           static_cast<int8_t>(static_cast<int8_t>(a >> (RawLimits<Raw>::width - 8)) ^
                               static_cast<int8_t>(b >> (RawLimits<Raw>::width - 8))) < 0;
}

// Whether a is -1, with which the smallest number has no quotient.
template <class Raw>
constexpr bool is_minus_one(Raw a) {
    return RawLimits<Raw>::is_signed && a == static_cast<Raw>(-1);
}

// The largest magnitude of a Raw of that sign.
template <class Word, class Raw>
constexpr Word largest_magnitude(bool negative) {
    return RawLimits<Raw>::is_signed
               ? static_cast<Word>(static_cast<Word>(RawLimits<Raw>::max) + (negative ? 1 : 0))
               : static_cast<Word>(negative ? Raw(0) : RawLimits<Raw>::max);
}

// `magnitude` with the sign restored, modulo 2^W.
template <class Raw>
constexpr Raw with_sign(Unsigned<Raw> magnitude, bool negative) {
    return static_cast<Raw>(negative ? static_cast<Unsigned<Raw>>(Unsigned<Raw>(0) - magnitude)
                                     : magnitude);
}

// A number of a wider type, saturated to the range of Raw.
template <class Raw, class Number>
constexpr Raw saturated(Number number) {
    return number > static_cast<Number>(RawLimits<Raw>::max)   ? RawLimits<Raw>::max
           : number < static_cast<Number>(RawLimits<Raw>::min) ? RawLimits<Raw>::min
                                                               : static_cast<Raw>(number);
}

// `magnitude` with the sign restored, saturated to the range of Raw.
template <class Raw, class Magnitude>
FIXEDPOINT_CONSTEXPR Raw saturated_with_sign(Magnitude magnitude, bool negative) {
    const Magnitude limit = static_cast<Magnitude>(RawLimits<Raw>::max);
    if (negative) {
        return magnitude > limit ? RawLimits<Raw>::min
                                 : static_cast<Raw>(-static_cast<Raw>(magnitude));
    }
    return magnitude > limit ? RawLimits<Raw>::max : static_cast<Raw>(magnitude);
}

}  // namespace fixedpoint
