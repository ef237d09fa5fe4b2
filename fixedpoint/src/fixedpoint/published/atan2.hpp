// SPDX-License-Identifier: MIT
// atan: the arc tangent of a ratio in [0, 1]; atan2: the angle of the point (x, y) in [0, 2 pi).
// atan2(0, 0) = 0. The result wraps in formats that cannot represent it.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/published/arc_tangent_table.hpp>
#include <fixedpoint/published/magnitude.hpp>

namespace fixedpoint {
namespace published {

// A number with 32 fraction bits truncated to F.
template <int F>
constexpr uint64_t from_32_fraction_bits(uint64_t value) {
    return F <= 32 ? value >> (F <= 32 ? 32 - F : 0) : value << (F <= 32 ? 0 : F - 32);
}

// pi / 2^halvings rounded to F fraction bits, from the 61 that 64 bits hold.
template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw pi_share(int halvings) {
    static_assert(F <= 60,
                  "pi is stored with 61 fraction bits: at most 60 can be rounded from it.");
    const uint64_t pi_61 = 0x6487ed5110b4611aull;
    const int drop = 61 - F + halvings;
    return static_cast<Raw>((pi_61 + (uint64_t(1) << (drop - 1))) >> drop);
}

// Linear interpolation between two of 201 entries of 64 bits. A ratio outside [0, 1] gives the
// nearer end; the original read beyond its table.
template <class Raw, int F>
Raw atan(Raw ratio) {
    // 200 intervals times a ratio of at most 1: 8 bits above the fraction suffice.
    using Position = UnsignedInteger<(RawLimits<Raw>::width < 16 ? 16 : RawLimits<Raw>::width)>;
    static_assert(
        F + 8 <= RawLimits<Position>::width,
        "The published arc tangent needs 8 bits above the fraction to address its table.");
    if (ratio <= 0) return 0;
    const Position one = static_cast<Position>(Position(1) << F);
    if (static_cast<Position>(ratio) >= one) {
        return static_cast<Raw>(from_32_fraction_bits<F>(arc_tangent_entry(arc_tangent_intervals)));
    }
    const Position position = static_cast<Position>(ratio) * arc_tangent_intervals;
    const uint8_t interval = static_cast<uint8_t>(position >> F);
    const Position fraction = position & static_cast<Position>(one - 1);
    const uint64_t below = arc_tangent_entry(interval);
    const uint64_t step = arc_tangent_entry(static_cast<uint8_t>(interval + 1)) - below;
    // step < 2^25 and fraction < 2^F; the product must fit in 64 bits, so F <= 39.
    static_assert(F <= 39,
                  "The published arc tangent interpolates in 64 bits: at most 39 fraction bits.");
    return static_cast<Raw>(from_32_fraction_bits<F>(below + ((step * fraction) >> F)));
}

// Three rotations fold the plane into its first octant, each adding its share of pi: by 180 degrees
// if y is negative, by 90 if x then is, by 45 if y then exceeds x. Corrected: the original folding
// did not terminate for (0, 0) or if x + y overflowed. On magnitudes the sum of x and a larger y is
// below 2^W, and each fold is taken at most once.
template <class Raw, int F>
Raw atan2(Raw y, Raw x) {
    if (x == 0 && y == 0) return 0;
    Unsigned<Raw> across = magnitude(x);
    Unsigned<Raw> up = magnitude(y);
    Unsigned<Raw> angle = 0;
    if (y < 0) angle += static_cast<Unsigned<Raw>>(pi_share<Raw, F>(0));
    if (y < 0 ? x > 0 : x < 0) {
        const Unsigned<Raw> turned = across;
        across = up;
        up = turned;
        angle += static_cast<Unsigned<Raw>>(pi_share<Raw, F>(1));
    }
    if (up > across) {
        const Unsigned<Raw> sum = across + up;
        up -= across;
        across = sum;
        angle += static_cast<Unsigned<Raw>>(pi_share<Raw, F>(2));
    }
    const Raw ratio = static_cast<Raw>(divide_magnitudes<Raw, F>(up, across));
    return static_cast<Raw>(angle + static_cast<Unsigned<Raw>>(atan<Raw, F>(ratio)));
}

}  // namespace published
}  // namespace fixedpoint
