// SPDX-License-Identifier: MIT
// Which code runs for an operation in a format: kernel::operation<Raw, F>.
//
// A format with an assembly kernel of its own (table.hpp) calls that. This file says what the
// others do: narrow formats use the kernels of Q8.8 and Q16.16, and 64-bit formats some of Q32.32,
// if those are accurate enough; formats of 24 bits use those of 32 bits (through_32_bits.hpp);
// everything else runs the portable implementation.
#pragma once

#include <fixedpoint/kernel/assembly.hpp>
#include <fixedpoint/kernel/table.hpp>
#include <fixedpoint/kernel/words.hpp>
#include <fixedpoint/portable/absolute.hpp>
#include <fixedpoint/portable/add_scaled.hpp>
#include <fixedpoint/portable/asin_q16_16.hpp>
#include <fixedpoint/portable/atan.hpp>
#include <fixedpoint/portable/atan2.hpp>
#include <fixedpoint/portable/cbrt_q32_32.hpp>
#include <fixedpoint/portable/convert.hpp>
#include <fixedpoint/portable/cross.hpp>
#include <fixedpoint/portable/divide.hpp>
#include <fixedpoint/portable/divide_small.hpp>
#include <fixedpoint/portable/dot.hpp>
#include <fixedpoint/portable/exp.hpp>
#include <fixedpoint/portable/exp_wide.hpp>
#include <fixedpoint/portable/fine_splits.hpp>
#include <fixedpoint/portable/length.hpp>
#include <fixedpoint/portable/lerp.hpp>
#include <fixedpoint/portable/log.hpp>
#include <fixedpoint/portable/multiply.hpp>
#include <fixedpoint/portable/multiply_add.hpp>
#include <fixedpoint/portable/multiply_saturating.hpp>
#include <fixedpoint/portable/multiply_words.hpp>
#include <fixedpoint/portable/normalise.hpp>
#include <fixedpoint/portable/pow_q32_32.hpp>
#include <fixedpoint/portable/reciprocal_sqrt.hpp>
#include <fixedpoint/portable/remainder.hpp>
#include <fixedpoint/portable/short_power.hpp>
#include <fixedpoint/portable/short_power_64.hpp>
#include <fixedpoint/portable/sin.hpp>
#include <fixedpoint/portable/sine_of_phase.hpp>
#include <fixedpoint/portable/split_64.hpp>
#include <fixedpoint/portable/sqrt.hpp>
#include <fixedpoint/portable/tan_of_rest.hpp>

// Every operation is declared first, since a kernel must be known before anything calls it.
namespace fixedpoint {
namespace kernel {
#define FIXEDPOINT_DECLARATION(shape, operation)        \
    template <class Raw, int F>                         \
    FIXEDPOINT_CONSTEXPR FIXEDPOINT_RESULT_##shape(Raw) \
        operation FIXEDPOINT_PARAMETERS_##shape(Raw);
FIXEDPOINT_COMPOSED_OPERATIONS(FIXEDPOINT_DECLARATION)
FIXEDPOINT_PORTABLE_OPERATIONS(FIXEDPOINT_DECLARATION)
#undef FIXEDPOINT_DECLARATION
template <class = uint32_t, int = 0>
FIXEDPOINT_CONSTEXPR uint64_t multiply_words(uint32_t a, uint32_t b);
}  // namespace kernel
}  // namespace fixedpoint

#include <fixedpoint/kernel/through_32_bits.hpp>

FIXEDPOINT_KERNELS(FIXEDPOINT_DISPATCH)

namespace fixedpoint {
namespace kernel {

// Functions of narrow formats go through Q16.16, whose kernels are many times faster than portable
// code.
using portable::through_q16_16;

// The functions of Q8.8 have kernels of their own, except the small variants. So have sine, cosine
// and logarithm in the coarser 16-bit formats.
template <class Raw, int F>
constexpr bool is_q8_8() {
    return sizeof(Raw) == 2 && F == 8;
}

// a in Q16.16, exact. Requires through_q16_16<Raw, F>().
template <class Raw, int F>
constexpr int32_t to_q16_16(Raw a) {
    return portable::convert<int32_t, 16, Raw, F>(a);
}

// a rounded to F fraction bits and saturated.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw from_q16_16(int32_t a) {
    return portable::convert_saturated<Raw, F, int32_t, 16>(a).number;
}

#define FIXEDPOINT_THROUGH_Q16_16(operation, has_own)                                  \
    template <class Raw, int F>                                                        \
    FIXEDPOINT_CONSTEXPR Raw operation(Raw a) {                                        \
        return through_q16_16<Raw, F>() && !(has_own)                                  \
                   ? from_q16_16<Raw, F>(operation<int32_t, 16>(to_q16_16<Raw, F>(a))) \
                   : portable::operation<Raw, F>(a);                                   \
    }
FIXEDPOINT_THROUGH_Q16_16(reciprocal_sqrt_small, false)
FIXEDPOINT_THROUGH_Q16_16(sin_small, false)
FIXEDPOINT_THROUGH_Q16_16(cos_small, false)
FIXEDPOINT_THROUGH_Q16_16(atan_small, false)
#undef FIXEDPOINT_THROUGH_Q16_16

// For angles of vectors and logarithms in 64-bit formats, Q32.32 is enough, whatever the units of
// the operands: an error of e ulp there becomes 1/2 + e 2^(F-32) ulp, at most 0.66 for F <= 30.
template <class Raw, int F>
constexpr bool through_q32_32() {
    return sizeof(Raw) == 8 && F <= 30;
}
// a rounded to F fraction bits. Requires through_q32_32<Raw, F>().
template <class Raw, int F>
constexpr Raw from_q32_32(int64_t a) {
    return portable::convert<Raw, F, int64_t, 32>(a);
}

// In 64-bit formats with 31 to 56 fraction bits, the kernels take that number as an operand; finer
// formats use portable code.
template <class Raw, int F, bool is_fine = portable::is_fine_split<Raw, F>()>
struct FineSplit {
    static constexpr Raw sin(Raw a) { return portable::sin<Raw, F>(a); }
    static constexpr Raw cos(Raw a) { return portable::cos<Raw, F>(a); }
    static FIXEDPOINT_CONSTEXPR void sincos(Raw a, Raw* pair) { portable::sincos<Raw, F>(a, pair); }
    static constexpr Raw atan(Raw a) { return portable::atan<Raw, F>(a); }
    static constexpr Raw atan2(Raw y, Raw x) { return portable::atan2<Raw, F>(y, x); }
    static constexpr Raw log(Raw a) { return portable::log<Raw, F>(a); }
};
template <class Raw, int F>
struct FineSplit<Raw, F, true> {
    static FIXEDPOINT_CONSTEXPR Raw sin(Raw a) { return sin_64<Raw, 0>(a, F); }
    static FIXEDPOINT_CONSTEXPR Raw cos(Raw a) { return cos_64<Raw, 0>(a, F); }
    static FIXEDPOINT_CONSTEXPR void sincos(Raw a, Raw* pair) { sincos_64<Raw, 0>(a, pair, F); }
    static FIXEDPOINT_CONSTEXPR Raw atan(Raw a) { return atan2_64<Raw, 0>(a, Raw(1) << F, F); }
    static FIXEDPOINT_CONSTEXPR Raw atan2(Raw y, Raw x) { return atan2_64<Raw, 0>(y, x, F); }
    static FIXEDPOINT_CONSTEXPR Raw log(Raw a) { return log_64<Raw, 0>(a, F); }
};

// For angles of vectors in coarse formats, Q8.8 is enough, whatever the units of the operands: an
// error of e ulp there becomes 1/2 + e 2^(F-8) ulp, at most 0.54 for F <= 4.
template <class Raw, int F>
constexpr bool through_q8_8() {
    return sizeof(Raw) <= 2 && F <= 4;
}
// a rounded to F fraction bits, half away from zero: vectors mirrored at the x axis have mirrored
// angles. Requires through_q8_8<Raw, F>().
template <class Raw, int F>
constexpr Raw from_q8_8(int16_t a) {
    return portable::convert<Raw, F, int16_t, 8>(static_cast<int16_t>(a < 0 ? a - 1 : a));
}

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw atan2(Raw y, Raw x) {
    return through_q8_8<Raw, F>() ? from_q8_8<Raw, F>(atan2<int16_t, 8>(static_cast<int16_t>(y),
                                                                        static_cast<int16_t>(x)))
           : through_q16_16<Raw, F>() && !is_q8_8<Raw, F>()
               ? from_q16_16<Raw, F>(atan2<int32_t, 16>(to_q16_16<Raw, F>(y), to_q16_16<Raw, F>(x)))
           : through_q32_32<Raw, F>() ? from_q32_32<Raw, F>(atan2<int64_t, 32>(y, x))
                                      : FineSplit<Raw, F>::atan2(y, x);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw atan(Raw a) {
    return through_q16_16<Raw, F>() && !is_q8_8<Raw, F>()
               ? from_q16_16<Raw, F>(atan<int32_t, 16>(to_q16_16<Raw, F>(a)))
           : through_q32_32<Raw, F>()
               ? from_q32_32<Raw, F>(atan2<int64_t, 32>(a, int64_t(1) << F % 63))
               : FineSplit<Raw, F>::atan(a);
}

// Sines go through Q32.32 too, for angles that it can represent; larger angles are reduced in their
// own units.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR bool is_angle_of_q32_32(Raw angle) {
    const int32_t upper = static_cast<int32_t>(upper_word(static_cast<uint64_t>(angle)));
    return (F == 0 ? static_cast<int32_t>(angle) >> 31 : upper >> 31) ==
           upper >> (F > 0 && F <= 30 ? F - 1 : 0);
}
template <class Raw, int F>
constexpr int64_t angle_of_q32_32(Raw angle) {
    return static_cast<int64_t>(static_cast<uint64_t>(angle) << (F <= 30 ? 32 - F : 0));
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR uint64_t quarter_turns(Raw angle);
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw sine_of(uint64_t quarter_turns) {
    return from_q32_32<Raw, F>(sine_of_quarter_turns<int64_t, 32>(quarter_turns));
}
#define FIXEDPOINT_SINE(operation, ahead)                                                        \
    template <class Raw, int F>                                                                  \
    FIXEDPOINT_CONSTEXPR Raw operation(Raw angle) {                                              \
        return through_q16_16<Raw, F>() && !portable::is_coarse_16<Raw, F>()                     \
                   ? from_q16_16<Raw, F>(operation<int32_t, 16>(to_q16_16<Raw, F>(angle)))       \
               : !through_q32_32<Raw, F>() ? FineSplit<Raw, F>::operation(angle)                 \
               : is_angle_of_q32_32<Raw, F>(angle)                                               \
                   ? from_q32_32<Raw, F>(operation<int64_t, 32>(angle_of_q32_32<Raw, F>(angle))) \
                   : sine_of<Raw, F>(quarter_turns<Raw, F>(angle) + (ahead));                    \
    }
FIXEDPOINT_SINE(sin, 0)
FIXEDPOINT_SINE(cos, portable::one_quarter_turn_q32_32)
#undef FIXEDPOINT_SINE

// 2^(3 F / 2) / sqrt(a) from 2^48 / sqrt(a) or, if F is odd, from that of 2 a or a / 2.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw reciprocal_sqrt_through_q32_32(int64_t a) {
    constexpr int exponent = 3 * F / 2;
    if (a == 0) return RawLimits<Raw>::max;
    if (F % 2 == 0) return from_q32_32<Raw, exponent - 16>(reciprocal_sqrt<int64_t, 32>(a));
    if (a >> 62 != 0) return from_q32_32<Raw, exponent - 16>(reciprocal_sqrt<int64_t, 32>(a >> 1));
    return from_q32_32<Raw, exponent - 15>(
        reciprocal_sqrt<int64_t, 32>(static_cast<int64_t>(static_cast<uint64_t>(a) << 1)));
}
// With more fraction bits, the reciprocal root is a quotient by the root of a 4^pairs, which has
// enough bits that its rounding costs at most 1/8 ulp for results below 2^60. Larger results are
// computed without their last `left` bits and refined by one step of Newton's method. Q32.32 has a
// kernel of its own.
template <class Raw, int F, bool by_root = sizeof(Raw) == 8 && (F > 30) && F != 32>
struct FineReciprocalSqrt {
    static FIXEDPOINT_CONSTEXPR Raw apply(Raw a) { return portable::reciprocal_sqrt<Raw, F>(a); }
};
template <int F>
struct FineReciprocalSqrt<int64_t, F, true> {
    static FIXEDPOINT_CONSTEXPR int64_t apply(int64_t a) {
        constexpr int64_t largest = RawLimits<int64_t>::max;
        if (a <= 0) return a == 0 ? largest : 0;
        constexpr int exponent = 3 * F / 2, bits = exponent < 90 ? exponent - 29 : 61;
        uint64_t normalised = static_cast<uint64_t>(a);
        uint8_t pairs = 0;
        if (normalised < uint64_t(1) << bits) {
            pairs = static_cast<uint8_t>((__builtin_clzll(normalised) - 1) >> 1);
            normalised <<= 2 * pairs;
        }
        if (exponent + pairs >= 95) return largest;
        const uint8_t left =
            static_cast<uint8_t>(exponent + pairs > 90 ? exponent + pairs - 90 : 0);
        const int64_t root = sqrt<int64_t, 62 + F % 2>(static_cast<int64_t>(normalised));
        const int64_t quotient = divide_64<int64_t, 0>(
            int64_t(1) << 62, root, static_cast<uint8_t>(exponent + pairs - left - 31 + F % 2));
        return left == 0 ? quotient : refined(normalised, static_cast<uint64_t>(quotient), left);
    }

  private:
    // r 2^left (1 + h / 2), where a r^2 = 2^(180 + F % 2) (1 - h).
    static FIXEDPOINT_CONSTEXPR int64_t refined(uint64_t a, uint64_t r, uint8_t left) {
        constexpr int64_t largest = RawLimits<int64_t>::max;
        if (r > uint64_t(1) << (63 - left)) return largest;
        // r^2 in four words, of which the lowest is dropped.
        const uint32_t r1 = upper_word(r), r0 = static_cast<uint32_t>(r);
        const uint64_t middle = 2 * multiply_words(r1, r0) + upper_word(multiply_words(r0, r0));
        const uint64_t upper = multiply_words(r1, r1) + upper_word(middle);
        const uint32_t a1 = upper_word(a), a0 = static_cast<uint32_t>(a);
        const uint32_t upper1 = upper_word(upper), upper0 = static_cast<uint32_t>(upper);
        const uint32_t above = upper_word(multiply_words(a0, upper0)) + a1 * upper0 + a0 * upper1 +
                               upper_word(multiply_words(a1, static_cast<uint32_t>(middle)));
        // h in units of 2^-72, or of 2^-73 if F is odd.
        const int32_t h = -(static_cast<int32_t>(above) >> 12);
        const int32_t change = static_cast<int32_t>(r1 >> 16) * h;
        const uint64_t result =
            (r << left) +
            static_cast<uint64_t>(static_cast<int64_t>(((change >> (24 + F % 2 - left)) + 1) >> 1));
        return result >> 63 != 0 ? largest : static_cast<int64_t>(result);
    }
};
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw reciprocal_sqrt(Raw a) {
    return through_q16_16<Raw, F>() && !is_q8_8<Raw, F>()
               ? from_q16_16<Raw, F>(reciprocal_sqrt<int32_t, 16>(to_q16_16<Raw, F>(a)))
           : through_q32_32<Raw, F>() ? reciprocal_sqrt_through_q32_32<Raw, F>(a)
                                      : FineReciprocalSqrt<Raw, F>::apply(a);
}
// Read in units of 2^-32 instead of 2^-F, a number has a logarithm that is (32 - F) ln 2 too small.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw log(Raw a) {
    constexpr int64_t ln2 = 24973259072661437;  // 2^-55
    return through_q16_16<Raw, F>() && !portable::is_coarse_16<Raw, F>()
               ? from_q16_16<Raw, F>(log<int32_t, 16>(to_q16_16<Raw, F>(a)))
           : through_q32_32<Raw, F>()
               ? (a > 0 ? from_q32_32<Raw, F>(log<int64_t, 32>(a) +
                                              (((32 - F) * ln2 + (int64_t(1) << 22)) >> 23))
                        : RawLimits<Raw>::min)
               : FineSplit<Raw, F>::log(a);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw atan2_small(Raw y, Raw x) {
    return through_q16_16<Raw, F>() ? from_q16_16<Raw, F>(atan2_small<int32_t, 16>(
                                          to_q16_16<Raw, F>(y), to_q16_16<Raw, F>(x)))
                                    : portable::atan2_small<Raw, F>(y, x);
}

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void sincos(Raw angle, Raw* sine_and_cosine) {
    if (through_q16_16<Raw, F>() && !portable::is_coarse_16<Raw, F>()) {
        int32_t wide[2] = {};
        sincos<int32_t, 16>(to_q16_16<Raw, F>(angle), wide);
        sine_and_cosine[0] = from_q16_16<Raw, F>(wide[0]);
        sine_and_cosine[1] = from_q16_16<Raw, F>(wide[1]);
    } else if (through_q32_32<Raw, F>() && is_angle_of_q32_32<Raw, F>(angle)) {
        int64_t fine[2] = {};
        sincos<int64_t, 32>(angle_of_q32_32<Raw, F>(angle), fine);
        sine_and_cosine[0] = from_q32_32<Raw, F>(fine[0]);
        sine_and_cosine[1] = from_q32_32<Raw, F>(fine[1]);
    } else if (through_q32_32<Raw, F>()) {
        const uint64_t turns = quarter_turns<Raw, F>(angle);
        sine_and_cosine[0] = sine_of<Raw, F>(turns);
        sine_and_cosine[1] = sine_of<Raw, F>(turns + portable::one_quarter_turn_q32_32);
    } else {
        FineSplit<Raw, F>::sincos(angle, sine_and_cosine);
    }
}

template <class, int>
FIXEDPOINT_CONSTEXPR uint64_t multiply_words(uint32_t a, uint32_t b) {
    return portable::multiply_words(a, b);
}
#define FIXEDPOINT_PORTABLE(shape, operation)                            \
    template <class Raw, int F>                                          \
    FIXEDPOINT_CONSTEXPR FIXEDPOINT_RESULT_##shape(Raw)                  \
        operation FIXEDPOINT_PARAMETERS_##shape(Raw) {                   \
        return portable::operation<Raw, F> FIXEDPOINT_ARGUMENTS_##shape; \
    }
FIXEDPOINT_PORTABLE_OPERATIONS(FIXEDPOINT_PORTABLE)
#undef FIXEDPOINT_PORTABLE

// All 64-bit formats share one product, quotient, root, dot product and exponential function, which
// take the fraction bits as an operand. Q32.32 has its own. Without kernels, portable code runs.
template <class Raw, int F,
          bool by_kernels = has_assembly && sizeof(Raw) == 8 && RawLimits<Raw>::is_signed>
struct Split {
    static FIXEDPOINT_CONSTEXPR Raw multiply(Raw a, Raw b) {
        return portable::multiply<Raw, F>(a, b);
    }
    static FIXEDPOINT_CONSTEXPR Raw divide(Raw a, Raw b) { return portable::divide<Raw, F>(a, b); }
    static FIXEDPOINT_CONSTEXPR Raw remainder(Raw a, Raw b) {
        return portable::remainder<Raw, F>(a, b);
    }
    static FIXEDPOINT_CONSTEXPR Raw sqrt(Raw a) { return portable::sqrt<Raw, F>(a); }
    static FIXEDPOINT_CONSTEXPR Raw exp(Raw a) { return portable::exp<Raw, F>(a); }
    static FIXEDPOINT_CONSTEXPR Raw dot(const Raw* a, const Raw* b, uint8_t n) {
        return portable::dot<Raw, F>(a, b, n);
    }
};
template <class Raw, int F>
struct Split<Raw, F, true> {
    static FIXEDPOINT_CONSTEXPR Raw multiply(Raw a, Raw b) { return multiply_64<Raw, 0>(a, b, F); }
    static FIXEDPOINT_CONSTEXPR Raw divide(Raw a, Raw b) { return divide_64<Raw, 0>(a, b, F); }
    static FIXEDPOINT_CONSTEXPR Raw sqrt(Raw a) { return sqrt_64<Raw, 0>(a, F); }
    static FIXEDPOINT_CONSTEXPR Raw exp(Raw a) { return exp_64<Raw, 0>(a, F); }
    static FIXEDPOINT_CONSTEXPR Raw dot(const Raw* a, const Raw* b, uint8_t n) {
        return dot_64<Raw, 0>(a, b, n, F);
    }
};
// Without a sign, numbers of 32 bits use the kernels with one wherever these are exact: below 2^31,
// for results below the largest number, and otherwise those of 64 bits. A product of 64 bits is the
// one of the same bits with a sign, and 2^(W-F) times each factor whose partner is then negative.
template <int F>
struct Split<uint32_t, F, false> {
    static FIXEDPOINT_CONSTEXPR uint32_t multiply(uint32_t a, uint32_t b) {
        return portable::multiply<uint32_t, F>(a, b);
    }
    static FIXEDPOINT_CONSTEXPR uint32_t divide(uint32_t a, uint32_t b) {
        if (!has_assembly) return portable::divide<uint32_t, F>(a, b);
        if (static_cast<int32_t>(a | b) >= 0) {
            const int32_t quotient =
                kernel::divide<int32_t, F>(static_cast<int32_t>(a), static_cast<int32_t>(b));
            if (quotient != RawLimits<int32_t>::max) return static_cast<uint32_t>(quotient);
        }
        return saturated<uint32_t>(
            divide_64<int64_t, 0>(static_cast<int64_t>(a), static_cast<int64_t>(b), F));
    }
    static FIXEDPOINT_CONSTEXPR uint32_t remainder(uint32_t a, uint32_t b) {
        return has_assembly && static_cast<int32_t>(a | b) >= 0
                   ? static_cast<uint32_t>(kernel::remainder<int32_t, 16>(static_cast<int32_t>(a),
                                                                          static_cast<int32_t>(b)))
                   : portable::remainder<uint32_t, F>(a, b);
    }
    static FIXEDPOINT_CONSTEXPR uint32_t sqrt(uint32_t a) {
        return !has_assembly ? portable::sqrt<uint32_t, F>(a)
               : a < uint32_t(1) << (F < 32 ? 31 : 30)
                   ? static_cast<uint32_t>(kernel::sqrt<int32_t, F>(static_cast<int32_t>(a)))
                   : static_cast<uint32_t>(sqrt_64<int64_t, 0>(static_cast<int64_t>(a), F));
    }
};
template <int F>
struct Split<uint64_t, F, false> {
    static FIXEDPOINT_CONSTEXPR uint64_t multiply(uint64_t a, uint64_t b) {
        if (!has_assembly) return portable::multiply<uint64_t, F>(a, b);
        uint64_t product = static_cast<uint64_t>(
            kernel::multiply<int64_t, F>(static_cast<int64_t>(a), static_cast<int64_t>(b)));
        if (static_cast<int64_t>(a) < 0) product += shift_up<64 - F>(b);
        if (static_cast<int64_t>(b) < 0) product += shift_up<64 - F>(a);
        return product;
    }
    static FIXEDPOINT_CONSTEXPR uint64_t divide(uint64_t a, uint64_t b) {
        return portable::divide<uint64_t, F>(a, b);
    }
    static FIXEDPOINT_CONSTEXPR uint64_t remainder(uint64_t a, uint64_t b) {
        return portable::remainder<uint64_t, F>(a, b);
    }
    static FIXEDPOINT_CONSTEXPR uint64_t sqrt(uint64_t a) { return portable::sqrt<uint64_t, F>(a); }
};

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw multiply(Raw a, Raw b) {
    return Split<Raw, F>::multiply(a, b);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw exp(Raw a) {
    return through_q16_16<Raw, F>() && !is_q8_8<Raw, F>()
               ? from_q16_16<Raw, F>(exp<int32_t, 16>(to_q16_16<Raw, F>(a)))
               : Split<Raw, F>::exp(a);
}
// Requires |a| < 1/4 and 0 <= b < 2.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw multiply_short(Raw a, Raw b) {
    return multiply<Raw, F>(a, b);
}
// In Q32.32 the product of the whole parts says whether the wrapped product can be trusted. If it
// is below 2^31, whole parts x and y, of which neither exceeds 2^31, have x y + x + y + 1 <= 2^32:
// the exact product is less than 2^64 ulp off zero, and out of range if its sign is lost.
constexpr uint32_t whole_part_of_magnitude(uint32_t whole, uint32_t fraction) {
    return whole >> 31 == 0 ? whole : ~whole + (fraction == 0 ? 1 : 0);
}
template <>
FIXEDPOINT_CONSTEXPR int64_t multiply_saturating<int64_t, 32>(int64_t a, int64_t b) {
    const uint32_t upper_a = upper_word(static_cast<uint64_t>(a)),
                   upper_b = upper_word(static_cast<uint64_t>(b));
    const uint64_t whole =
        multiply_words(whole_part_of_magnitude(upper_a, static_cast<uint32_t>(a)),
                       whole_part_of_magnitude(upper_b, static_cast<uint32_t>(b)));
    const bool negative = (upper_a ^ upper_b) >> 31 != 0;
    if (upper_word(whole) == 0 && static_cast<uint32_t>(whole) >> 31 == 0) {
        const int64_t wrapped = multiply<int64_t, 32>(a, b);
        const bool is_below = upper_word(static_cast<uint64_t>(wrapped)) >> 31 != 0;
        if (is_below == negative || wrapped == 0) return wrapped;
    }
    return negative ? RawLimits<int64_t>::min : RawLimits<int64_t>::max;
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw multiply_add(Raw a, Raw b, Raw c) {
    return wrapping_add(multiply<Raw, F>(a, b), c);
}

// a + t (b - a), rounded once, modulo 2^W. If b - a is out of range, the wrapped difference is 2^W
// too small or too large, which the product with t turns into t 2^(W-F).
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw wrapping_lerp(Raw a, Raw b, Raw t) {
    const Raw difference = wrapping_subtract(b, a);
    Raw start = a;
    if (RawLimits<Raw>::is_signed ? signs_differ(a, b) && signs_differ(b, difference) : b < a) {
        const Raw missing = wrapping_shift_left(t, RawLimits<Raw>::width - F);
        start = !RawLimits<Raw>::is_signed || b < 0 ? wrapping_subtract(a, missing)
                                                    : wrapping_add(a, missing);
    }
    return multiply_add<Raw, F>(t, difference, start);
}

// In formats of 8 and 16 bits, the quotient is that of a and b 2^(16 - F) in Q16.16, rounded once.
// Without a sign, b 2^16 does not fit.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw divide(Raw a, Raw b) {
    return has_assembly && sizeof(Raw) <= 2 &&
                   (RawLimits<Raw>::is_signed || sizeof(Raw) == 1 || F > 0)
               ? saturated<Raw>(divide<int32_t, 16>(
                     static_cast<int32_t>(a),
                     static_cast<int32_t>(b) * (int32_t(1) << (F < 16 ? 16 - F : 0))))
               : Split<Raw, F>::divide(a, b);
}
// noinline: once in a program, however many quotients it computes.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR __attribute__((noinline)) Raw divide_small(Raw a, Raw b) {
    return portable::divide_small<Raw, F>(a, b);
}
// The remainder does not depend on the fraction bits.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw remainder(Raw a, Raw b) {
    return !has_assembly || !RawLimits<Raw>::is_signed ? Split<Raw, F>::remainder(a, b)
           : sizeof(Raw) == 8 ? static_cast<Raw>(remainder<int64_t, 32>(static_cast<int64_t>(a),
                                                                        static_cast<int64_t>(b)))
           : sizeof(Raw) == 4 ? static_cast<Raw>(remainder<int32_t, 16>(static_cast<int32_t>(a),
                                                                        static_cast<int32_t>(b)))
           : sizeof(Raw) == 2 ? static_cast<Raw>(remainder<int16_t, 8>(static_cast<int16_t>(a),
                                                                       static_cast<int16_t>(b)))
                              : static_cast<Raw>(remainder<int8_t, 4>(static_cast<int8_t>(a),
                                                                      static_cast<int8_t>(b)));
}
// Neither do divrem and divmod. Of all quotients of 8 bits, only -128 / -1 is out of range. Numbers
// without a sign have no kernel.
#define FIXEDPOINT_DIVISION(operation)                                                        \
    template <class Raw>                                                                      \
    FIXEDPOINT_CONSTEXPR void raw_##operation(Raw a, Raw b, Raw* pair) {                      \
        portable::operation<Raw, 0>(a, b, pair);                                              \
    }                                                                                         \
    FIXEDPOINT_CONSTEXPR void raw_##operation(int16_t a, int16_t b, int16_t* pair) {          \
        operation<int16_t, 8>(a, b, pair);                                                    \
    }                                                                                         \
    FIXEDPOINT_CONSTEXPR void raw_##operation(int8_t a, int8_t b, int8_t* pair) {             \
        int16_t wide[2] = {};                                                                 \
        raw_##operation(static_cast<int16_t>(a), static_cast<int16_t>(b), wide);              \
        pair[0] = saturated<int8_t>(wide[0]);                                                 \
        pair[1] = static_cast<int8_t>(wide[1]);                                               \
    }                                                                                         \
    FIXEDPOINT_CONSTEXPR void raw_##operation(int32_t a, int32_t b, int32_t* pair) {          \
        operation<int32_t, 16>(a, b, pair);                                                   \
    }                                                                                         \
    FIXEDPOINT_CONSTEXPR void raw_##operation(int64_t a, int64_t b, int64_t* pair) {          \
        operation<int64_t, 32>(a, b, pair);                                                   \
    }                                                                                         \
    template <class Raw, int F>                                                               \
    FIXEDPOINT_CONSTEXPR void operation(Raw a, Raw b, Raw* pair) {                            \
        has_assembly ? raw_##operation(a, b, pair) : portable::operation<Raw, F>(a, b, pair); \
    }
FIXEDPOINT_DIVISION(divrem)
FIXEDPOINT_DIVISION(divmod)
#undef FIXEDPOINT_DIVISION

// Nor do these. Up to 32 bits the compiler's code is as good.
#define FIXEDPOINT_OF_64_BITS(operation)                                                           \
    template <class Raw, int F>                                                                    \
    FIXEDPOINT_CONSTEXPR Raw operation(Raw a, Raw b) {                                             \
        return has_assembly && sizeof(Raw) == 8 && RawLimits<Raw>::is_signed                       \
                   ? static_cast<Raw>(                                                             \
                         operation<int64_t, 32>(static_cast<int64_t>(a), static_cast<int64_t>(b))) \
                   : portable::operation<Raw, F>(a, b);                                            \
    }
FIXEDPOINT_OF_64_BITS(copysign)
FIXEDPOINT_OF_64_BITS(abs_diff)
#undef FIXEDPOINT_OF_64_BITS

// In formats of 8 and 16 bits, the root is that of the integer a 2^F, rounded once, and with 16
// fraction bits that of Q16.16.
template <int F>
constexpr int fraction_of_root() {
    return F == 16 ? 16 : 0;
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw sqrt(Raw a) {
    return has_assembly && sizeof(Raw) <= 2
               ? saturated<Raw>(sqrt<int32_t, fraction_of_root<F>()>(
                     static_cast<int32_t>(a) * (int32_t(1) << (F < 16 ? F : 0))))
               : Split<Raw, F>::sqrt(a);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw sqrt_small(Raw a) {
    return portable::sqrt<Raw, F>(a);
}

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw dot2(const Raw* a, const Raw* b) {
    return Split<Raw, F>::dot(a, b, 2);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw dot3(const Raw* a, const Raw* b) {
    return Split<Raw, F>::dot(a, b, 3);
}

// dot2 and dot3; their kernels are fastest if a is a unit vector.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw project2(const Raw* a, const Raw* b) {
    return dot2<Raw, F>(a, b);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw project3(const Raw* a, const Raw* b) {
    return dot3<Raw, F>(a, b);
}
// The dot product of a vector with itself.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw square2(const Raw* v) {
    return project2<Raw, F>(v, v);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw square3(const Raw* v) {
    return project3<Raw, F>(v, v);
}

// As the portable functions, but with this format's kernels for dot products and products.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw dot_difference2(const Raw* n, const Raw* u, const Raw* v) {
    const Raw difference[2] = {wrapping_subtract(u[0], v[0]), wrapping_subtract(u[1], v[1])};
    return dot2<Raw, F>(difference, n);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw dot_difference3(const Raw* n, const Raw* u, const Raw* v) {
    const Raw difference[3] = {wrapping_subtract(u[0], v[0]), wrapping_subtract(u[1], v[1]),
                               wrapping_subtract(u[2], v[2])};
    return dot3<Raw, F>(difference, n);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void add_scaled2(Raw* sum, const Raw* v, Raw factor) {
    sum[0] = multiply_add<Raw, F>(v[0], factor, sum[0]);
    sum[1] = multiply_add<Raw, F>(v[1], factor, sum[1]);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void add_scaled3(Raw* sum, const Raw* v, Raw factor) {
    add_scaled2<Raw, F>(sum, v, factor);
    sum[2] = multiply_add<Raw, F>(v[2], factor, sum[2]);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void exchange1(Raw* a, Raw* b, Raw v, Raw factor) {
    const Raw product = multiply<Raw, F>(v, factor);
    *a = wrapping_add(*a, product);
    *b = wrapping_subtract(*b, product);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void exchange2(Raw* a, Raw* b, const Raw* v, Raw factor) {
    exchange1<Raw, F>(a, b, v[0], factor);
    exchange1<Raw, F>(a + 1, b + 1, v[1], factor);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void exchange3(Raw* a, Raw* b, const Raw* v, Raw factor) {
    exchange2<Raw, F>(a, b, v, factor);
    exchange1<Raw, F>(a + 2, b + 2, v[2], factor);
}

// The fraction bits cancel, so a width needs only one length: the kernel of its format with equal
// integer and fraction bits, which rounds to nearest as the portable code does.
#define FIXEDPOINT_LENGTH(length, Raw, F) \
    FIXEDPOINT_CONSTEXPR Raw raw_##length(const Raw* v) { return length<Raw, F>(v); }
FIXEDPOINT_LENGTH(length2, int8_t, 4)
FIXEDPOINT_LENGTH(length2, int16_t, 8)
FIXEDPOINT_LENGTH(length2, int32_t, 16)
FIXEDPOINT_LENGTH(length2, int64_t, 32)
FIXEDPOINT_LENGTH(length3, int8_t, 4)
FIXEDPOINT_LENGTH(length3, int16_t, 8)
FIXEDPOINT_LENGTH(length3, int32_t, 16)
FIXEDPOINT_LENGTH(length3, int64_t, 32)
#undef FIXEDPOINT_LENGTH

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw length2(const Raw* v) {
    return has_assembly ? raw_length2(v) : portable::length2<Raw, F>(v);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw length3(const Raw* v) {
    return has_assembly ? raw_length3(v) : portable::length3<Raw, F>(v);
}

template <class Raw, int F>
struct LengthAndDivision {
    static FIXEDPOINT_CONSTEXPR Raw length3(const Raw* v) { return kernel::length3<Raw, F>(v); }
    static FIXEDPOINT_CONSTEXPR Raw divide(Raw a, Raw b) { return kernel::divide<Raw, F>(a, b); }
};
template <class Raw, int F, bool by_length = portable::normalises_by_length<Raw, F>()>
struct Normalisation {
    static FIXEDPOINT_CONSTEXPR void apply(const Raw* v, Raw* unit) {
        portable::normalise_by_length<Raw, F, LengthAndDivision<Raw, F>>(v, unit);
    }
};
template <class Raw, int F>
struct Normalisation<Raw, F, false> {
    static FIXEDPOINT_CONSTEXPR void apply(const Raw* v, Raw* unit) {
        portable::normalise3<Raw, F>(v, unit);
    }
};
// Used only without assembly; with it, these are kernels.
template <int F>
struct Normalisation<int32_t, F, true> : Normalisation<int32_t, F, false> {};
template <>
struct Normalisation<int64_t, 32, true> : Normalisation<int64_t, 32, false> {};

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void normalise3(const Raw* v, Raw* unit) {
    if (through_q16_16<Raw, F>() && !is_q8_8<Raw, F>()) {
        int32_t wide[3] = {to_q16_16<Raw, F>(v[0]), to_q16_16<Raw, F>(v[1]),
                           to_q16_16<Raw, F>(v[2])};
        normalise3<int32_t, 16>(wide, wide);
        for (unsigned char i = 0; i < 3; ++i) unit[i] = from_q16_16<Raw, F>(wide[i]);
    } else {
        Normalisation<Raw, F>::apply(v, unit);
    }
}

}  // namespace kernel
}  // namespace fixedpoint

#include <fixedpoint/kernel/quarter_turns_64.hpp>
