// SPDX-License-Identifier: MIT
// The dispatch of normalise3: which code a format runs through.
#pragma once

#include <fixedpoint/kernel/assembly.hpp>
#include <fixedpoint/kernel/divide.hpp>
#include <fixedpoint/kernel/length.hpp>
#include <fixedpoint/kernel/through_q16_16.hpp>
#include <fixedpoint/portable/normalise.hpp>

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
struct LengthAndDivision {
    static constexpr Raw length3(const Raw* v) { return kernel::length3<Raw, F>(v); }
    static constexpr Raw divide(Raw a, Raw b) { return kernel::divide<Raw, F>(a, b); }
};

template <class Raw, int F, bool by_length = portable::normalises_by_length<Raw, F>>
struct Normalisation {
    static constexpr void apply(const Raw* v, Raw* unit) {
        portable::normalise_by_length<Raw, F, LengthAndDivision<Raw, F>>(v, unit);
    }
};
template <class Raw, int F>
struct Normalisation<Raw, F, false> {
    static constexpr void apply(const Raw* v, Raw* unit) { portable::normalise3<Raw, F>(v, unit); }
};
// On the host; on the device its kernel takes this place.
template <>
struct Normalisation<int32_t, 16, true> : Normalisation<int32_t, 16, false> {};

template <class Raw, int F>
constexpr void normalise3(const Raw* v, Raw* unit) {
    if (through_q16_16<Raw, F>) {
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

FIXEDPOINT_ASSEMBLY_KERNEL(void, normalise3, int32_t, 16, fixedpoint_normalise3_q16_16, normalise3,
                           (const int32_t* v, int32_t* unit), (v, unit))
