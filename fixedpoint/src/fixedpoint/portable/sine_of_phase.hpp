// SPDX-License-Identifier: MIT
// The sine of a reduced angle: a phase, the fractional part of the angle in turns as an integer.
// Sines of radians and of turns end in it.
#pragma once

#include <fixedpoint/portable/sin_16.hpp>
#include <fixedpoint/portable/sin_32.hpp>
#include <fixedpoint/portable/sin_q16_16.hpp>
#include <fixedpoint/portable/sin_q32_32.hpp>

namespace fixedpoint {
namespace portable {

// In 16-bit formats with up to 8 fraction bits the phase has 16 bits, and the table includes half a
// unit of it. In Q16.16 it has 32 bits, of which the lowest six do not matter.
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

// In Q8.8 and in Q16.16: the sine of turns 2^-F, whose fractional part is half of a phase.
template <class Raw, int F>
constexpr Raw sine_of_turns(Raw turns) {
    return sine_of_phase<Raw, F>(static_cast<Raw>(static_cast<Unsigned<Raw>>(turns) << F));
}

// In 32-bit formats and in Q32.32: the sine of quarter turns with 40 fraction bits, of which the
// low 42 bits count.
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
