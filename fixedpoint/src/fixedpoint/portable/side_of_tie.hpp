// SPDX-License-Identifier: MIT
// On which side of a tie the exact result of a function of one number lies, in any format of up to
// 32 bits: reaches<F>(n, a) says whether f(a 2^-F) >= n 2^-(F+1). n must be odd, and the two must
// differ by less than 2^-16 ulp.
//
// Each question is a comparison with a power of e or with a sine and a cosine, since a logarithm or
// an arc reaches a tie if its argument reaches the inverse function of the tie: ln a >= t if
// a >= e^t. A power of e has a relative error below 2^-67, or 2^-100 with more than 17 fraction
// bits; a sine has an error below 2^-110.
//
// Hardly any result is a tie. By Lindemann's theorem the functions of e and those of angles have
// only transcendental values, apart from those at 0 and 1, which are numbers of the format. log2
// and log10 have only irrational values, apart from those of whole powers, which are whole. So has
// exp2, apart from whole operands: 2^-(F+1) is a tie, and it is computed without an error. The cube
// of a tie has more than F fraction bits, so no cube root is one.
//
// The other results are decided unless one is closer to a tie than the errors. In Q8.24 none is: of
// all operands, tests/hardest_ties.cpp found the closest, a log10, 2^-34.7 ulp from a tie, and the
// errors are below 2^-60 ulp. Other formats were not searched completely. Of 2^32 results spread at
// random, the closest is about 2^-33 ulp from a tie; the errors are below 2^-48 ulp, except those
// of the largest powers of e with up to 16 fraction bits, below 2^-36 ulp, which have few operands.
#pragma once

#include <fixedpoint/portable/exponentials.hpp>
#include <fixedpoint/portable/sin.hpp>

namespace fixedpoint {
namespace portable {
namespace side_of_tie {

// Powers.

template <int f>
constexpr int power_digits() {
    return f <= 17 ? 66 : 100;
}
// e^(x 2^-122), or its reciprocal, for a number x of up to f fraction bits. x must be at most 46
// 2^122.
template <int digits>
FIXEDPOINT_CONSTEXPR __attribute__((noinline)) Power<Word128> power_of_e(const Word128& x,
                                                                         bool reciprocal) {
    return exponential<int64_t, digits>(x, reciprocal);
}
// e^(n 2^-f).
template <int f>
FIXEDPOINT_CONSTEXPR Power<Word128> power_of_e(int64_t n) {
    return power_of_e<power_digits<f>()>(Word128(magnitude(n)) << (122 - f), n < 0);
}
// 2^(n 2^-f), for 0 < f <= 32.
template <int f>
FIXEDPOINT_CONSTEXPR Power<Word128> power_of_2(int64_t n) {
    const Word128 rest = multiply_by_half_word<int64_t>(PseudoDivisionConstants<Word128>::ln2(),
                                                        static_cast<uint64_t>(n) << (64 - f));
    return {exponential_mantissa<power_digits<f>()>(rest), static_cast<int>(n >> f)};
}
// 10^(n 2^-f), for |n| < 2^(f+4) and f <= 32. 10 = 2^3 (1 + 2^-2).
template <int f>
FIXEDPOINT_CONSTEXPR Power<Word128> power_of_10(int64_t n) {
    const Word128 ln10 =
        PseudoDivisionConstants<Word128>::ln2() * 3 + logarithm_of_factor<Word128, 2>(2);
    return power_of_e<power_digits<f>()>(
        multiply_by_half_word<int64_t>(ln10, magnitude(n) << (60 - f)) << 4, n < 0);
}
// Whether a power is at least n 2^-f. The two must differ by a factor below 2.
template <int f>
FIXEDPOINT_CONSTEXPR bool is_at_least(const Power<Word128>& power, uint64_t n) {
    return power.mantissa >= (Word128(n) << (125 - f - power.exponent));
}

struct Exp {
    template <int F>
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t n, int32_t a) {
        return is_at_least<F + 1>(power_of_e<F>(a), static_cast<uint64_t>(n));
    }
};
struct Exp2 {
    template <int F>
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t n, int32_t a) {
        return is_at_least<F + 1>(power_of_2<F + 1>(2 * int64_t(a)), static_cast<uint64_t>(n));
    }
};
struct Expm1 {
    template <int F>
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t n, int32_t a) {
        return Exp::reaches<F>(n + (int64_t(2) << F), a);
    }
};
// Logarithms: whether a number reaches a power of the tie.
struct Log {
    template <int F>
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t n, int64_t a) {
        return !is_at_least<F>(power_of_e<F + 1>(n), static_cast<uint64_t>(a));
    }
};
struct Log2 {
    template <int F>
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t n, int32_t a) {
        return !is_at_least<F>(power_of_2<F + 1>(n), static_cast<uint64_t>(a));
    }
};
struct Log10 {
    template <int F>
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t n, int32_t a) {
        return !is_at_least<F>(power_of_10<F + 1>(n), static_cast<uint64_t>(a));
    }
};
struct Log1p {
    template <int F>
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t n, int32_t a) {
        return Log::reaches<F>(n, a + (int64_t(1) << F));
    }
};

// The powers of the hyperbolic functions, below 2^34, in units of 2^-92: with an error below 2^-66
// of the largest and 2^-91 of those near 1.
FIXEDPOINT_CONSTEXPR Word128 in_units_of_hyperbolic(const Power<Word128>& power) {
    return in_units<124>(power, 92);
}
struct Sinh {
    template <int F>
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t n, int32_t a) {
        const int64_t positive = magnitude(a);
        const Word128 twice = in_units_of_hyperbolic(power_of_e<F>(positive)) -
                              in_units_of_hyperbolic(power_of_e<F>(-positive));
        return (twice >= (Word128(magnitude(n)) << (92 - F))) == (a > 0);
    }
};
struct Cosh {
    template <int F>
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t n, int32_t a) {
        const int64_t positive = magnitude(a);
        const Word128 twice = in_units_of_hyperbolic(power_of_e<F>(positive)) +
                              in_units_of_hyperbolic(power_of_e<F>(-positive));
        return twice >= (Word128(magnitude(n)) << (92 - F));
    }
};
// (1 - p) / (1 + p) >= t, with p = e^-2|a|, if 1 - t >= p (1 + t).
struct Tanh {
    template <int F>
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t n, int32_t a) {
        constexpr uint64_t one = uint64_t(2) << F;
        const Word128 power = in_units_of_hyperbolic(power_of_e<F>(-2 * int64_t(magnitude(a))));
        return ((Word128(one - magnitude(n)) << 92) >= power * (one + magnitude(n))) == (a > 0);
    }
};

// a 2^(2F+3) >= n^3, decided by their small difference modulo 2^64.
struct Cbrt {
    template <int F>
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t n, int32_t a) {
        constexpr int shift = 2 * F + 3 < 64 ? 2 * F + 3 : 63;
        const uint64_t root = static_cast<uint64_t>(n);
        const uint64_t cube = 2 * F + 3 < 64 ? static_cast<uint64_t>(int64_t(a)) << shift : 0;
        return !is_negative(cube - root * root * root);
    }
};

// Angles.

// Cosine and sine of n 2^-f, with 126 fraction bits.
template <int f>
FIXEDPOINT_CONSTEXPR UnitVector<Word128> unit_vector_at(int64_t n) {
    using Constants = CordicConstants<Word128>;
    const uint64_t positive = magnitude(n);
    const uint64_t quarters = static_cast<uint64_t>(
        (Constants::two_over_pi() * positive + (Word128(1) << (63 + f))) >> (64 + f));
    const Word128 rest = (Word128(positive) << (126 - f)) - Constants::half_pi() * quarters +
                         ((Word128(half_pi_excess) * quarters) >> 64);
    const UnitVector<Word128> unit = unit_vector<110>(rest);
    const bool odd = (quarters & 1) != 0, beyond = (quarters & 2) != 0;
    const Word128 cosine = odd ? unit.sine : unit.cosine;
    const Word128 sine = odd ? unit.cosine : unit.sine;
    return {beyond != odd ? negated(cosine) : cosine, beyond != (n < 0) ? negated(sine) : sine};
}
// n 2^-f with 126 fraction bits.
template <int f>
FIXEDPOINT_CONSTEXPR Word128 with_126_bits(int64_t n) {
    const Word128 positive = Word128(magnitude(n)) << (126 - f);
    return n < 0 ? negated(positive) : positive;
}
constexpr bool is_at_least(const Word128& a, const Word128& b) { return !is_negative(a - b); }
constexpr Word128 absolute(const Word128& a) { return is_negative(a) ? negated(a) : a; }

struct Sin {
    template <int F>
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t n, int32_t a) {
        return is_at_least(unit_vector_at<F>(a).sine, with_126_bits<F + 1>(n));
    }
};
struct Cos {
    template <int F>
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t n, int32_t a) {
        return is_at_least(unit_vector_at<F>(a).cosine, with_126_bits<F + 1>(n));
    }
};
// |sine| >= |t| |cosine|, in units of 2^-127. The product is close to the sine and fits.
struct Tan {
    template <int F>
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t n, int32_t a) {
        const UnitVector<Word128> unit = unit_vector_at<F>(a);
        return ((absolute(unit.sine) << 1) >= (absolute(unit.cosine) >> F) * magnitude(n)) ==
               (n > 0);
    }
};
// A tie may be beyond the largest angle, in the direction in which the other coordinate is
// negative.
struct Asin {
    template <int F>
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t n, int32_t a) {
        const UnitVector<Word128> unit = unit_vector_at<F + 1>(n);
        return is_negative(unit.cosine) ? n < 0 : is_at_least(with_126_bits<F>(a), unit.sine);
    }
};
struct Acos {
    template <int F>
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t n, int32_t a) {
        const UnitVector<Word128> unit = unit_vector_at<F + 1>(n);
        return !is_negative(unit.sine) && is_at_least(unit.cosine, with_126_bits<F>(a));
    }
};
// |a| cosine >= |sine|, in units of 2^-126.
struct Atan {
    template <int F>
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t n, int32_t a) {
        const UnitVector<Word128> unit = unit_vector_at<F + 1>(n);
        if (is_negative(unit.cosine)) return n < 0;
        return ((unit.cosine >> F) * magnitude(a) >= absolute(unit.sine)) == (n > 0);
    }
};

}  // namespace side_of_tie
}  // namespace portable
}  // namespace fixedpoint
