// SPDX-License-Identifier: MIT
// The rounding of a result of a number of up to 32 bits that a finer format gives: Q32.32 or, with
// more than 16 fraction bits, the format of 64 bits with 16 more.
//
// A finer result with an error below one of its units decides the rounding, unless it is itself a
// tie: from one unit above the tie on, the exact result is above it; from one unit below, it is
// not. About once in 2^16 results it is a tie. Then a side, such as those of side_of_tie.hpp, says
// whether the exact result is at least the tie: reaches<F>(n, a) for the tie n 2^-(F+1).
#pragma once

#include <fixedpoint/portable/convert.hpp>
#include <fixedpoint/portable/double_word.hpp>

namespace fixedpoint {
namespace portable {

template <int F>
constexpr int finer_fraction() {
    return F <= 16 ? 32 : F + 16;
}
template <class Raw, int F>
constexpr int64_t finer(Raw a) {
    return convert<int64_t, finer_fraction<F>(), Raw, F>(a);
}

// The exact result, from which `fine`, in the finer format, must differ by less than its unit,
// rounded to F fraction bits, half up, and saturated.
template <class Raw, int F, class Side, class... Operands>
FIXEDPOINT_CONSTEXPR Raw correctly_rounded(int64_t fine, Operands... a) {
    static_assert(sizeof(Raw) <= 4, "CorrectlyRounded needs a format of at most 32 bits.");
    constexpr uint32_t half = uint32_t(1) << (finer_fraction<F>() - F - 1);
    const Converted<Raw> up = convert_saturated<Raw, F, int64_t, finer_fraction<F>()>(fine);
    const bool is_tie = (static_cast<uint32_t>(fine) & (2 * half - 1)) == half;
    // Results below the smallest number saturate, whichever side of the tie they are on.
    if (!is_tie || !up.fits || up.number == RawLimits<Raw>::min) return up.number;
    return Side::template reaches<F>(2 * int64_t(up.number) - 1, a...)
               ? up.number
               : static_cast<Raw>(up.number - 1);
}

// A side that takes the tie in units of 2^-32 and operands of Q16.16.
template <class Side>
struct InQ16_16 {
    template <int F, class Raw, class... Raws>
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t n, Raw a, Raws... others) {
        static_assert(F <= 16 && RawLimits<Raw>::width - F <= 16,
                      "atan2 and pow of CorrectlyRounded need a format whose numbers are all "
                      "numbers of Q16.16.");
        return Side::reaches(n * (int64_t(1) << (31 - F)), convert<int32_t, 16, Raw, F>(a),
                             convert<int32_t, 16, Raws, F>(others)...);
    }
};

// v / sqrt(v^2 + a^2 + b^2) >= t if v^2 2^(2F+2) >= n^2 (v^2 + a^2 + b^2), for v and n of one sign.
struct UnitComponentSide {
    template <int F>
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t n, int32_t v, int32_t a, int32_t b) {
        const uint64_t component = magnitude(n);
        const Word128 exact = Word128(square(v)) << (2 * F + 2);
        const Word128 at_tie = Word128(square(v) + square(a) + square(b)) * (component * component);
        return v < 0 ? !(exact > at_tie) : !(exact < at_tie);
    }
};

// The result with 48 fraction bits, for arcs, which have few operands: the side of each was
// compared with an evaluation of 113 bits. Powers have too many pairs for that: they are correct
// unless one is closer to a tie than 2^-48. A power that is a tie, such as 1.5^17, evaluates to
// exactly the tie.
template <class Function>
struct WideSide {
    template <class... Operands>
    static FIXEDPOINT_CONSTEXPR bool reaches(int64_t tie, Operands... a) {
        return Function::template apply<int64_t, 48>(convert<int64_t, 48, int32_t, 16>(a)...)
                   .number >= tie * (int64_t(1) << 16);
    }
};

}  // namespace portable
}  // namespace fixedpoint
