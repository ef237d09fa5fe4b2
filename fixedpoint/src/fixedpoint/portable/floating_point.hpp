// SPDX-License-Identifier: MIT
// IEEE 754 numbers to and from raw numbers. Float is float or double, distinguished only by size:
// on the 8-bit device both have 32 bits. Infinities and NaN are valid inputs.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/converted.hpp>

namespace fixedpoint {
namespace portable {

template <int Bytes>
struct FloatLayout;
template <>
struct FloatLayout<4> {
    using Bits = uint32_t;
    static constexpr int mantissa_bits = 23;
    static constexpr int exponent_bias = 127;
};
template <>
struct FloatLayout<8> {
    using Bits = uint64_t;
    static constexpr int mantissa_bits = 52;
    static constexpr int exponent_bias = 1023;
};

template <class Float>
FIXEDPOINT_CONSTEXPR typename FloatLayout<sizeof(Float)>::Bits bits_of(Float x) {
    using Bits = typename FloatLayout<sizeof(Float)>::Bits;
#ifdef __AVR__
    // Not a constant expression for this compiler, but folded if x is a constant.
    Bits bits = 0;
    __builtin_memcpy(&bits, &x, sizeof bits);
    return bits;
#else
    return __builtin_bit_cast(Bits, x);
#endif
}

// x rounded to nearest, half up, and saturated; NaN gives 0, which does not fit.
template <class Raw, int F, class Float>
FIXEDPOINT_CONSTEXPR Converted<Raw> from_float(Float x) {
    using Layout = FloatLayout<sizeof(Float)>;
    using Bits = typename Layout::Bits;
    using Word = UnsignedInteger<(sizeof(Raw) > sizeof(Bits)) ? 64 : RawLimits<Bits>::width>;
    constexpr int m = Layout::mantissa_bits;
    constexpr int exponent_mask = 2 * Layout::exponent_bias + 1;

    const Bits bits = bits_of(x);
    const bool negative = (bits >> (RawLimits<Bits>::width - 1)) != 0;
    const int exponent = static_cast<int>(bits >> m) & exponent_mask;
    const Bits fraction = bits & ((Bits(1) << m) - 1);
    const Converted<Raw> saturated = {negative ? RawLimits<Raw>::min : RawLimits<Raw>::max, false};
    if (exponent == exponent_mask) return fraction != 0 ? Converted<Raw>{0, false} : saturated;

    // |x| 2^F = mantissa 2^shift. Subnormals need no special case: anything below 2^-125 is far
    // less than half an ulp of any format.
    Word mantissa = fraction | (Bits(1) << m);
    const int shift = exponent - Layout::exponent_bias - m + F;
    const Word limit = largest_magnitude<Word, Raw>(negative);
    if (shift >= 0) {
        if (shift >= RawLimits<Raw>::width || mantissa > (limit >> shift)) return saturated;
        mantissa <<= shift;
    } else if (-shift > m + 2) {
        mantissa = 0;
    } else {
        const Word half = Word(1) << (-shift - 1);
        mantissa += negative ? half - 1 : half;
        mantissa >>= -shift;
        if (mantissa > limit) return saturated;
    }
    return {with_sign<Raw>(static_cast<Unsigned<Raw>>(mantissa), negative), true};
}

// a / 2^F rounded to the nearest Float, half to even, as IEEE 754 does by default.
template <class Float, class Raw, int F>
constexpr Float to_float(Raw a) {
    // Only the conversion of the integer rounds: the product with a power of two is exact.
    return static_cast<Float>(a) * (Float(1) / static_cast<Float>(uint64_t(1) << F));
}

}  // namespace portable
}  // namespace fixedpoint
