// SPDX-License-Identifier: MIT
// asin and acos: faithful, error below 0.75 ulp (below 2 ulp with more than 58 fraction bits),
// saturated. An argument outside [-1, 1] counts as the nearer end.
#pragma once

#include <fixedpoint/portable/atan2.hpp>
#include <fixedpoint/portable/evaluation.hpp>
#include <fixedpoint/portable/nearest_root.hpp>

namespace fixedpoint {
namespace portable {

// sqrt(a) in a unit far smaller than the unit of the angle: scaled by 2^((F + 12) / 2) in a 32-bit
// root if that fits.
template <int F, bool narrow = (F <= 24)>
struct RootOfSum {
    static FIXEDPOINT_CONSTEXPR uint32_t apply(uint64_t a) {
        return static_cast<uint32_t>(nearest_root<int32_t>(a << (F + 12)));
    }
};
template <int F>
struct RootOfSum<F, false> {
    static FIXEDPOINT_CONSTEXPR uint64_t apply(uint64_t a) {
        return static_cast<uint64_t>(nearest_root<int64_t>(Word128(a) << (124 - F)));
    }
};

// acos(a 2^-F) for 0 <= a < 2^F, in the scale of first_quadrant_angle: twice the angle of (sqrt(1 +
// a), sqrt(1 - a)), which avoids cancellation at both ends.
template <int F>
FIXEDPOINT_CONSTEXPR CordicWord<F + 1> acute_arc_cosine(uint64_t a) {
    constexpr uint64_t one = uint64_t(1) << F;
    return first_quadrant_angle<F + 1>(RootOfSum<F>::apply(one - a), RootOfSum<F>::apply(one + a))
           << 1;
}

template <class Raw, int F>
constexpr bool beyond_one(Raw a) {
    return magnitude(a) > static_cast<Unsigned<Raw>>(Unsigned<Raw>(1) << F);
}
template <class Raw, int F>
constexpr bool from_one_on(Raw a) {
    return magnitude(a) >= static_cast<Unsigned<Raw>>(Unsigned<Raw>(1) << F);
}
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Evaluation<Raw> arc(const CordicWord<F + 1>& angle, Raw a, bool negative) {
    const Evaluation<Raw> result =
        evaluation<Raw>(angle, cordic_bits<CordicWord<F + 1>>() - 2 - F, negative);
    return {result.number, beyond_one<Raw, F>(a) ? Outcome::domain_error : result.outcome};
}

struct Asin {
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Evaluation<Raw> apply(Raw a) {
        using Word = CordicWord<F + 1>;
        const Word right = CordicConstants<Word>::half_pi();
        if (from_one_on<Raw, F>(a)) return arc<Raw, F>(right, a, a < 0);
        const Word complement = acute_arc_cosine<F>(magnitude(a));
        return arc<Raw, F>(complement < right ? right - complement : Word(uint8_t(0)), a, a < 0);
    }
};
struct Acos {
    template <class Raw, int F>
    static FIXEDPOINT_CONSTEXPR Evaluation<Raw> apply(Raw a) {
        using Word = CordicWord<F + 1>;
        const Word angle =
            from_one_on<Raw, F>(a) ? Word(uint8_t(0)) : acute_arc_cosine<F>(magnitude(a));
        return arc<Raw, F>(a < 0 ? CordicConstants<Word>::pi() - angle : angle, a, false);
    }
};

}  // namespace portable
}  // namespace fixedpoint
