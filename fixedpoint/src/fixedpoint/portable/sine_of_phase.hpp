// SPDX-License-Identifier: MIT
// The sine of an angle that is reduced already: a phase, the angle in turns as an integer of which
// the whole turns are left out. Sines of radians and of turns end in it.
#pragma once

#include <fixedpoint/portable/sin_16.hpp>
#include <fixedpoint/portable/sin_32.hpp>
#include <fixedpoint/portable/sin_q16_16.hpp>
#include <fixedpoint/portable/sin_q32_32.hpp>

namespace fixedpoint {
namespace portable {

// In the splits of 16 bits with up to 8 fraction bits, of a phase of 16 bits, half a unit of which
// is in the chords; in Q16.16, of 32 bits, the lowest six of which have no influence.
template <class Raw, int F>
struct SineOfPhase;
template <int F>
struct SineOfPhase<int16_t, F> {
    static FIXEDPOINT_CONSTEXPR int16_t of(int16_t phase) {
        return sine_of_phase_16<F>(static_cast<uint16_t>(phase));
    }
};
template <>
struct SineOfPhase<int32_t, 16> {
    static FIXEDPOINT_CONSTEXPR int32_t of(int32_t phase) {
        return sine_of_quarter_turns_q16_16(static_cast<uint32_t>(phase) >> 6);
    }
};
template <class Raw, int F>
constexpr Raw sine_of_phase(Raw phase) {
    return SineOfPhase<Raw, F>::of(phase);
}

// In the splits of 32 bits and in Q32.32, of quarter turns with 40 fraction bits, of which 42 bits
// count.
template <class Raw, int F>
struct SineOfQuarterTurns {
    static FIXEDPOINT_CONSTEXPR Raw of(uint64_t turns) {
        return sine_of_quarter_turns_32<F>(turns);
    }
};
template <>
struct SineOfQuarterTurns<int64_t, 32> {
    static FIXEDPOINT_CONSTEXPR int64_t of(uint64_t turns) {
        return sine_of_quarter_turns_q32_32(turns);
    }
};
template <class Raw, int F>
constexpr Raw sine_of_quarter_turns(uint64_t turns) {
    return SineOfQuarterTurns<Raw, F>::of(turns);
}

}  // namespace portable
}  // namespace fixedpoint
