// SPDX-License-Identifier: MIT
/// \file
/// interpolate: linear interpolation in a table of equidistant values.
#pragma once

#include <fixedpoint/blocks/number.hpp>
#include <fixedpoint/blocks/table.hpp>

namespace fixedpoint {

/// The implementation for float and double.
/// \cond internal
template <class Number>
struct Interpolation {
    template <int StepExponent, uint16_t N>
    static Number apply(const Table<Number, N>& table, Number begin, Number x) {
        constexpr Number steps_per_unit =
            StepExponent < 0 ? Number(1ul << (StepExponent < 0 ? -StepExponent : 0))
                             : 1 / Number(1ul << (StepExponent < 0 ? 0 : StepExponent));
        const Number steps = (x - begin) * steps_per_unit;
        if (!(steps > 0)) return table[0];
        if (steps >= N - 1) return table[N - 1];
        const uint16_t i = static_cast<uint16_t>(steps);
        return table[i] + (table[i + 1] - table[i]) * (steps - i);
    }
};
template <int IntegerBits, int F, class A>
struct Interpolation<Fixed<IntegerBits, F, A>> {
    using Number = Fixed<IntegerBits, F, A>;
    using Raw = typename Number::Raw;
    // The weight of the next entry is the part of the distance below the step: a number of F +
    // StepExponent fraction bits, so the product is rounded only once, whatever the step.
    template <int StepExponent, uint16_t N>
    static Number apply(const Table<Number, N>& table, Number begin, Number x) {
        constexpr int bits = F + StepExponent;
        static_assert(bits >= 0, "A step must be at least one ulp.");
        static_assert(bits < RawLimits<Raw>::width - 1 &&
                          N - 1 <= RawLimits<Raw>::max >> (bits < 0 ? 0 : bits),
                      "The table must not extend over more than the largest number.");
        if (x <= begin) return table[0];
        const Raw distance = Saturating::subtract<Raw, F>(x.raw(), begin.raw());
        if (distance >> bits >= static_cast<Raw>(N - 1)) return table[N - 1];
        const uint16_t i = static_cast<uint16_t>(distance >> bits);
        const Raw weight = static_cast<Raw>(distance & ((Raw(1) << bits) - 1));
        const Number left = table[i], difference = table[i + 1] - left;
        return Number::from_raw(
            A::template multiply_add<Raw, bits>(difference.raw(), weight, left.raw()));
    }
};
/// \endcond

/// The function at x by linear interpolation, rounded once. Entry i of the table is its value at
/// begin + i 2^StepExponent. Adjacent entries must not differ by more than the largest number.
///
/// The result is defined for every x: the first entry below `begin`, and the last entry beyond its
/// place.
template <int StepExponent, class Number, uint16_t N>
Number interpolate(const Table<Number, N>& table, Number begin, Number x) {
    return Interpolation<Number>::template apply<StepExponent>(table, begin, x);
}

}  // namespace fixedpoint
