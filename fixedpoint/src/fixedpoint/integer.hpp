// SPDX-License-Identifier: MIT
// The two's-complement integers that carry fixed-point numbers: Integer<Bits>, their unsigned
// partners, the integer of twice the width, and the few wrapping operations that C++ leaves
// undefined on signed types. Needs nothing but <stdint.h>, so that it compiles for the chip.
#pragma once

#include <stdint.h>

// Macros of the Arduino core and of Windows that would break every function of these names, the
// library's included. Integers and floats keep abs and round from <stdlib.h> and <math.h>.
#undef abs
#undef max
#undef min
#undef round

namespace fixedpoint {

template <int Bits>
struct IntegerOf {
    static_assert(
        Bits == 8 || Bits == 16 || Bits == 32 || Bits == 64,
        "A fixed-point number has 8, 16, 32 or 64 bits: choose IntegerBits + FractionBits "
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

template <class Raw>
constexpr int width_of = static_cast<int>(8 * sizeof(Raw));
template <class Raw>
using Unsigned = UnsignedInteger<width_of<Raw>>;
template <class Raw>
using Wide = Integer<2 * width_of<Raw>>;

// The largest and the smallest value of a Raw.
template <class Raw>
constexpr Raw raw_max = static_cast<Raw>((Unsigned<Raw>(1) << (width_of<Raw> - 1)) - 1);
template <class Raw>
constexpr Raw raw_min = static_cast<Raw>(-raw_max<Raw> - 1);

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

// a 2^count modulo 2^W, 0 from count = W on.
template <class Raw>
constexpr Raw wrapping_shift_left(Raw a, unsigned char count) {
    return count >= width_of<Raw> ? Raw(0)
                                  : static_cast<Raw>(static_cast<Unsigned<Raw>>(
                                        static_cast<Unsigned<Raw>>(a) << count));
}

// |a| as an unsigned number: exact for the smallest value too.
template <class Raw>
constexpr Unsigned<Raw> magnitude(Raw a) {
    return a < 0 ? static_cast<Unsigned<Raw>>(Unsigned<Raw>(0) - static_cast<Unsigned<Raw>>(a))
                 : static_cast<Unsigned<Raw>>(a);
}

// `magnitude` with the sign put back, modulo 2^W.
template <class Raw>
constexpr Raw with_sign(Unsigned<Raw> magnitude, bool negative) {
    return static_cast<Raw>(
        static_cast<Unsigned<Raw>>(negative ? Unsigned<Raw>(0) - magnitude : magnitude));
}

// The Raw nearest to a number of a wider type.
template <class Raw, class Number>
constexpr Raw clamped(Number number) {
    return number > raw_max<Raw>   ? raw_max<Raw>
           : number < raw_min<Raw> ? raw_min<Raw>
                                   : static_cast<Raw>(number);
}

// `magnitude` with the sign put back, saturated to what a Raw holds.
template <class Raw, class Magnitude>
constexpr Raw clamped_with_sign(Magnitude magnitude, bool negative) {
    const Magnitude limit = static_cast<Magnitude>(raw_max<Raw>);
    if (negative) {
        return magnitude > limit ? raw_min<Raw> : static_cast<Raw>(-static_cast<Raw>(magnitude));
    }
    return magnitude > limit ? raw_max<Raw> : static_cast<Raw>(magnitude);
}

}  // namespace fixedpoint
