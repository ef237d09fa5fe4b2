// SPDX-License-Identifier: MIT
// Sines of angles in turns and degrees, and angles of vectors in those units. The fraction of a
// turn is the reduced angle already, so nothing is rounded before the core of the sine.
#pragma once

#include <fixedpoint/kernel/atan2_degrees_q32_32.hpp>
#include <fixedpoint/kernel/dispatch.hpp>
#include <fixedpoint/kernel/words.hpp>

namespace fixedpoint {
namespace kernel {

// A core takes a phase, the fractional part of the angle in turns with phase_bits fraction bits,
// and returns the sine.

// 16-bit formats with up to 8 fraction bits: a phase of 16 bits, to which finer ones are truncated.
template <class Raw, int F>
struct SineOfPhase16 {
    using Phase = uint16_t;
    static constexpr int phase_bits = 16;
    static FIXEDPOINT_CONSTEXPR Raw sine(Phase phase) {
        return sine_of_phase<Raw, F>(static_cast<Raw>(phase));
    }
};
// Within 0.67 ulp in Q16.16, so within 0.59 ulp in formats of up to 13 fraction bits.
template <class Raw, int F>
struct SineOfPhase32 {
    using Phase = uint32_t;
    static constexpr int phase_bits = 32;
    static FIXEDPOINT_CONSTEXPR Raw sine(Phase phase) {
        return from_q16_16<Raw, F>(sine_of_phase<int32_t, 16>(static_cast<int32_t>(phase)));
    }
};
// Formats of up to 24 bits for which Q16.16 is too coarse use the sine of the 32-bit format with as
// many fraction bits.
template <class Raw, int F>
struct SineOfPhase42 {
    using Phase = uint64_t;
    static constexpr int phase_bits = 42;
    static FIXEDPOINT_CONSTEXPR Raw sine(Phase phase) {
        return saturated<Raw>(sine_of_quarter_turns<int32_t, F>(phase));
    }
};
template <int F>
struct SineOfPhase42<int64_t, F> {
    using Phase = uint64_t;
    static constexpr int phase_bits = 42;
    static FIXEDPOINT_CONSTEXPR int64_t sine(Phase phase) {
        return from_q32_32<int64_t, F>(sine_of_quarter_turns<int64_t, 32>(phase));
    }
};
// A shorter phase, which is enough for an angle in turns, in Q8.8 and in the formats of
// SineOfPhase32. What is above it is ignored.
struct SineOfPhase8 {
    using Phase = uint16_t;
    static constexpr int phase_bits = 8;
    static FIXEDPOINT_IN_PLACE int16_t sine(Phase phase) {
        return sine_of_turns<int16_t, 8>(static_cast<int16_t>(phase));
    }
};
template <class Raw, int F>
struct ShortSineOfPhase32 {
    using Phase = uint16_t;
    static constexpr int phase_bits = 16;
    static FIXEDPOINT_IN_PLACE Raw sine(Phase phase) {
        return from_q16_16<Raw, F>(sine_of_turns<int32_t, 16>(static_cast<int32_t>(phase)));
    }
};
// By itself, since the chip's compiler does not inline a conversion that changes nothing.
template <>
struct ShortSineOfPhase32<int32_t, 16> {
    using Phase = uint32_t;
    static constexpr int phase_bits = 16;
    static FIXEDPOINT_IN_PLACE int32_t sine(Phase phase) {
        return sine_of_turns<int32_t, 16>(static_cast<int32_t>(phase));
    }
};
// For every format.
template <class Raw, int F>
struct SineOfPhase64 {
    using Phase = uint64_t;
    static constexpr int phase_bits = 64;
    static FIXEDPOINT_CONSTEXPR Raw sine(Phase phase) {
        using Word = portable::CordicWord<F>;
        // The nearest quarter turn, and the distance from it times pi/2 2^126.
        const uint8_t quarters = static_cast<uint8_t>((phase + (uint64_t(1) << 61)) >> 62);
        const int64_t distance =
            static_cast<int64_t>(phase - (static_cast<uint64_t>(quarters) << 62));
        const portable::Word128 half_pi = portable::CordicConstants<portable::Word128>::half_pi();
        const portable::Word128 angle =
            (portable::Word128(magnitude(distance)) * half_pi.high << 2) +
            (portable::Word128(magnitude(distance)) * half_pi.low >> 62);
        const portable::UnitVector<Word> unit = portable::unit_vector<F>(
            static_cast<Word>((distance < 0 ? portable::negated(angle) : angle) >>
                              (128 - portable::cordic_bits<Word>())));
        return portable::round_signed_from_cordic<Raw, F>(
            (quarters & 1) != 0 ? unit.cosine : unit.sine, (quarters & 2) != 0);
    }
};

template <bool condition, class Then, class Else>
struct Either {
    using Type = Then;
};
template <class Then, class Else>
struct Either<false, Then, Else> {
    using Type = Else;
};
template <class Raw, int F>
using SineOfPhase = typename Either<
    portable::is_coarse_16<Raw, F>(), SineOfPhase16<Raw, F>,
    typename Either<through_q16_16<Raw, F>() || (sizeof(Raw) > 2 && sizeof(Raw) <= 4 && F == 16),
                    SineOfPhase32<Raw, F>,
                    typename Either<sizeof(Raw) <= 4 || F <= 30 || F == 32, SineOfPhase42<Raw, F>,
                                    SineOfPhase64<Raw, F>>::Type>::Type>::Type;

// The core for turns with F fraction bits.
template <class Core>
struct ShortPhase {
    using Type = Core;
};
template <>
struct ShortPhase<SineOfPhase16<int16_t, 8>> {
    using Type = SineOfPhase8;
};
template <class Raw, int F>
struct ShortPhase<SineOfPhase32<Raw, F>> {
    using Type = ShortSineOfPhase32<Raw, F>;
};

template <class Core>
constexpr typename Core::Phase quarter_turn() {
    return static_cast<typename Core::Phase>(typename Core::Phase(1) << (Core::phase_bits - 2));
}

// The phase of an angle in turns, exact. It is 0 if there are no fraction bits.
template <class Core, class Raw, int F>
constexpr typename Core::Phase phase_of_turns(Raw angle) {
    using Phase = typename Core::Phase;
    return F == 0 ? Phase(0)
                  : static_cast<Phase>(static_cast<Phase>(angle)
                                       << (F == 0 ? 0 : Core::phase_bits - F));
}

// floor(32 n / 45), exact at multiples of 45. n must be at most 2^37 / 43, which is above 360 2^23.
FIXEDPOINT_CONSTEXPR uint32_t over_45(uint32_t n) {
    return static_cast<uint32_t>(multiply_words(n, 0xb60b60b7) >> 32);
}

// rest / (360 2^F) of a turn, truncated: exact for quarter turns. rest must be less than 360 2^F,
// unless the phase has 16 bits, which drop whole turns.
template <int F, int phase_bits>
struct PhaseOfDegrees {
    static FIXEDPOINT_CONSTEXPR uint32_t of(uint32_t rest) {
        const uint32_t phase = over_45(rest << ((phase_bits == 16 ? 8 : 23) - F));
        // Truncated to the 26 significant bits before the sign is applied, so that an angle and its
        // negative are truncated alike.
        return phase_bits == 16 ? phase : phase << 1 & ~uint32_t(63);
    }
};
// rest 2^(39 - F) / 45 by long division in two digits, the lower one of 24 bits.
template <int F>
struct PhaseOfDegrees<F, 42> {
    static constexpr int below = F > 15 ? F - 15 : 0, above = F > 15 ? 0 : 15 - F;
    template <class Word>
    static FIXEDPOINT_CONSTEXPR uint64_t of(Word rest) {
        const uint32_t upper = static_cast<uint32_t>(rest >> below) << above;
        const uint32_t lower = static_cast<uint32_t>(rest) & ((uint32_t(1) << below) - 1);
        const uint32_t digit = over_45(upper) >> 5;
        return (static_cast<uint64_t>(digit) << 24) +
               (over_45(((upper - 45 * digit) << 24) + (lower << (24 - below))) >> 5);
    }
};
template <int F>
struct PhaseOfDegrees<F, 64> {
    static FIXEDPOINT_CONSTEXPR uint64_t of(uint64_t rest) {
        return portable::divide_full(rest, 0, uint64_t(360) << F).quotient;
    }
};
template <class Core, class Raw, int F>
FIXEDPOINT_CONSTEXPR typename Core::Phase phase_of_degrees(Raw angle) {
    static_assert(F <= 54, "Angles in degrees have at most 54 fraction bits.");
    using Phase = typename Core::Phase;
    constexpr uint64_t turn = uint64_t(360) << F;
    constexpr bool is_reduced =
        Core::phase_bits == 16 || turn > static_cast<Unsigned<Raw>>(RawLimits<Raw>::max);
    const Unsigned<Raw> rest =
        magnitude(is_reduced ? angle : remainder<Raw, F>(angle, static_cast<Raw>(turn)));
    const Phase phase = static_cast<Phase>(PhaseOfDegrees<F, Core::phase_bits>::of(rest));
    return angle < 0 ? static_cast<Phase>(Phase(0) - phase) : phase;
}

// 1 / (2 pi) in units of 2^-66 and 180 / pi in units of 2^-58. An angle depends only on the ratio
// of the raws, not on their fraction bits.
constexpr uint64_t turns_per_radian = 0xa2f9836e4e44152a, degrees_per_radian = 0xe52ee0d31e0fbdc3;

// The angle of (x, y) in radians of Q32.32, times factor 2^-64, rounded and saturated. The product
// must stay below 2^32 units of the result.
template <class Raw>
FIXEDPOINT_CONSTEXPR Raw coarse_angle_of(Raw y, Raw x, uint64_t factor) {
    const int64_t angle = atan2<int64_t, 32>(static_cast<int64_t>(y), static_cast<int64_t>(x));
    const uint64_t product = static_cast<uint64_t>(multiply<int64_t, 32>(
        static_cast<int64_t>(magnitude(angle)), static_cast<int64_t>(factor)));
    return saturated_with_sign<Raw>(upper_word(product + (uint32_t(1) << 31)), angle < 0);
}

// angle factor 2^-Bits rounded to F fraction bits and saturated; angle has FromF fraction bits.
template <class Raw, int F, int FromF, int Bits>
FIXEDPOINT_CONSTEXPR Raw scaled_angle(int64_t angle, uint64_t factor) {
    constexpr int shift = Bits + FromF - F - 64;
    static_assert(shift >= 0, "Angles in degrees have at most 54 fraction bits.");
    const portable::Wide128 product = portable::multiply_full(magnitude(angle), factor);
    const uint64_t rounded = shift > 0 ? ((product.high >> (shift > 0 ? shift - 1 : 0)) + 1) >> 1
                                       : product.high + (product.low >> 63);
    return saturated_with_sign<Raw>(rounded, angle < 0);
}

// The angle of (x, y) in radians, times factor 2^-Bits.
template <class Raw, int F, int Bits>
FIXEDPOINT_CONSTEXPR Raw angle_of(Raw y, Raw x, uint64_t factor) {
    constexpr int fraction_bits = sizeof(Raw) == 4 ? 60 : 61;
    return scaled_angle<Raw, F, fraction_bits, Bits>(
        atan2<int64_t, fraction_bits>(static_cast<int64_t>(y), static_cast<int64_t>(x)), factor);
}
template <class Raw, int F, bool is_short = (sizeof(Raw) <= 4 && F <= 16)>
struct AngleOfVector {
    // An angle of Q32.32 errs by 0.65 ulp, and the product by less than one: an eighth of an ulp in
    // turns of up to 32 fraction bits, and a sixth in degrees of up to 24.
    static FIXEDPOINT_CONSTEXPR Raw in_turns(Raw y, Raw x) {
        return F <= 32 ? coarse_angle_of<Raw>(y, x, turns_per_radian >> (F <= 32 ? 34 - F : 0))
                       : angle_of<Raw, F, 66>(y, x, turns_per_radian);
    }
    static FIXEDPOINT_CONSTEXPR Raw in_degrees(Raw y, Raw x) {
        return F <= 24 ? coarse_angle_of<Raw>(y, x, degrees_per_radian >> (F <= 24 ? 26 - F : 0))
                       : angle_of<Raw, F, 58>(y, x, degrees_per_radian);
    }
};
// Up to 16 fraction bits, a 32-bit angle in radians and the product err by 2^-5 ulp together.
template <class Raw, int F>
struct AngleOfVector<Raw, F, true> {
    static FIXEDPOINT_CONSTEXPR int32_t in_radians(Raw y, Raw x) {  // 2^-28
        return atan2<int32_t, 28>(static_cast<int32_t>(y), static_cast<int32_t>(x));
    }
    // angle 2^-bits, rounded to F bits.
    template <int bits>
    static FIXEDPOINT_CONSTEXPR Raw rounded(int32_t angle) {
        return saturated<Raw>((angle + (int32_t(1) << (bits - F - 1))) >> (bits - F));
    }
    static FIXEDPOINT_CONSTEXPR Raw in_turns(Raw y, Raw x) {
        constexpr int32_t per_radian = 1367130551;  // 2^-33
        return rounded<29>(multiply<int32_t, 32>(in_radians(y, x), per_radian));
    }
    static FIXEDPOINT_CONSTEXPR Raw in_degrees(Raw y, Raw x) {
        constexpr int32_t per_radian = 1922527338;  // 2^-25
        return rounded<21>(multiply<int32_t, 32>(in_radians(y, x), per_radian));
    }
};
// In Q32.32, an angle in radians has enough digits for one in turns.
template <>
struct AngleOfVector<int64_t, 32, false> {
    static FIXEDPOINT_CONSTEXPR int64_t in_turns(int64_t y, int64_t x) {
        constexpr int64_t per_radian = 44798133900177;  // 2^-48
        return (multiply<int64_t, 32>(atan2<int64_t, 32>(y, x), per_radian) + (int64_t(1) << 15)) >>
               16;
    }
    static FIXEDPOINT_CONSTEXPR int64_t in_degrees(int64_t y, int64_t x) {
        return q32_32::atan2_degrees(y, x);
    }
};

}  // namespace kernel
}  // namespace fixedpoint
