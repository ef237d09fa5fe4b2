// SPDX-License-Identifier: MIT
// normalise3: v / |v|, in place or elsewhere; a zero vector stays zero. Each component is, bit for
// bit as the kernels compute it, within 0.77 ulp in Q16.16, 0.66 ulp in Q8.8, 0.6 ulp in Q32.32,
// and in other 32-bit formats 0.56 ulp with up to 24 fraction bits and 0.91 ulp with 25 to 27;
// within 0.97 ulp in other formats if normalises_by_length; and rounded to nearest in the rest.
#pragma once

#include <fixedpoint/portable/divide.hpp>
#include <fixedpoint/portable/length.hpp>
#include <fixedpoint/portable/normalise_32.hpp>
#include <fixedpoint/portable/normalise_q32_32.hpp>
#include <fixedpoint/portable/normalise_q8_8.hpp>
#include <fixedpoint/portable/reciprocal_sqrt.hpp>

namespace fixedpoint {
namespace portable {

// Whether the format has four bits above 2^F, which normalise_by_length needs for scaling.
template <class Raw, int F>
constexpr bool normalises_by_length() {
    return sizeof(Raw) >= 4 && F <= RawLimits<Raw>::width - 5;
}

// v / |v| by the length and the division of Operations, a class that has both for Raw and F.
//
// v is scaled first, so that its largest component is at least 2^(F + 2), and below 2^(W - 2) for
// the length to fit. Scaling up is exact: the length, half a unit off, then causes an error of 1/8
// ulp in a component, and the division 1/2 ulp. If components are halved and rounded, each is up to
// 1/2 off, and the length, at least 2^(W - 3) >= 2^(F + 2), up to sqrt(3) / 2 + 1/2: 0.47 ulp
// together.
template <class Raw, int F, class Operations>
FIXEDPOINT_CONSTEXPR void normalise_by_length(const Raw* v, Raw* unit) {
    constexpr int W = RawLimits<Raw>::width, room = W - 4 - F, step = room < 8 ? room : 8;
    Raw scaled[3] = {v[0], v[1], v[2]};
    // Has the leading one of the largest component or, for -2^n, a lower one, but at least bit 0.
    Unsigned<Raw> largest = (v[0] | v[1] | v[2]) != 0;
    for (const Raw component : scaled) {
        largest = static_cast<Unsigned<Raw>>(
            largest | static_cast<Unsigned<Raw>>(component < 0 ? ~component : component));
    }
    if (largest >> (W - 2) != 0) {
        for (Raw& component : scaled) {
            component = static_cast<Raw>((component >> 1) + (component & 1));
        }
    } else if (largest != 0) {
        for (; largest >> (F + 2) == 0; largest = static_cast<Unsigned<Raw>>(largest << step)) {
            for (Raw& component : scaled) component = wrapping_shift_left(component, step);
        }
    }
    const Raw length = Operations::length3(scaled);
    for (uint8_t i = 0; i < 3; ++i) unit[i] = Operations::divide(scaled[i], length);
}

template <class Raw, int F>
struct LengthAndDivision {
    static constexpr Raw length3(const Raw* v) { return portable::length3<Raw, F>(v); }
    static constexpr Raw divide(Raw a, Raw b) { return portable::divide<Raw, F>(a, b); }
};

template <class Raw, int F, bool by_length = normalises_by_length<Raw, F>()>
struct Normalisation {
    static FIXEDPOINT_CONSTEXPR void apply(const Raw* v, Raw* unit) {
        normalise_by_length<Raw, F, LengthAndDivision<Raw, F>>(v, unit);
    }
};

template <class Raw, int F>
struct Normalisation<Raw, F, false> {
    static FIXEDPOINT_CONSTEXPR void apply(const Raw* v, Raw* unit) {
        const DoubleWord<Raw> length_squared = sum_of_squares(v, 3);
        for (int i = 0; i < 3; ++i) {
            // The zero vector does not have ratios, and a zero component does not need one. With
            // one integer bit, the format can represent -1 but not 1.
            if (v[i] < 0) {
                unit[i] = wrapping_negate(
                    nearest_root_of_ratio<Raw, DoubleWord<Raw>,
                                          uint64_t(1) << (RawLimits<Raw>::width - 1)>(
                        square(v[i]), length_squared, 2 * F));
            } else {
                unit[i] = v[i] == 0
                              ? Raw(0)
                              : nearest_root_of_ratio<Raw>(square(v[i]), length_squared, 2 * F);
            }
        }
    }
};

template <int F>
struct Normalisation<int32_t, F, true> {
    static FIXEDPOINT_CONSTEXPR void apply(const int32_t* v, int32_t* unit) {
        normalise3_32<F>(v, unit);
    }
};

template <>
struct Normalisation<int64_t, 32, true> {
    static FIXEDPOINT_CONSTEXPR void apply(const int64_t* v, int64_t* unit) {
        normalise3_q32_32(v, unit);
    }
};

template <>
struct Normalisation<int16_t, 8, false> {
    static FIXEDPOINT_CONSTEXPR void apply(const int16_t* v, int16_t* unit) {
        normalise3_q8_8(v, unit);
    }
};

// The steps of the kernel; their error budget is in avr/normalise3_q16_16.S.
template <>
struct Normalisation<int32_t, 16, true> {
    static FIXEDPOINT_CONSTEXPR void apply(const int32_t* v, int32_t* unit) {
        uint32_t scaled[3] = {};
        uint32_t largest = 0;
        for (int i = 0; i < 3; ++i) {
            scaled[i] = v[i] == RawLimits<int32_t>::min ? magnitude(RawLimits<int32_t>::max)
                                                        : magnitude(v[i]);
            largest |= scaled[i];
        }
        if (largest == 0) {
            for (int i = 0; i < 3; ++i) unit[i] = 0;
            return;
        }
        int shift = 0;
        while (largest >> 30 == 0) {
            largest <<= 1;
            ++shift;
        }
        uint32_t sum = 0;
        for (uint32_t& a : scaled) {
            a = a << shift >> 8;
            sum += (a >> 8) * (a >> 8) + 2 * (a >> 16) * (a & 0xff);
        }
        const bool small = sum >> 30 == 0;
        const uint32_t reciprocal = reciprocal_root_mantissa(small ? sum << 2 : sum)
                                    << (small ? 1 : 0);
        for (int i = 0; i < 3; ++i) {
            const uint32_t a = scaled[i];
            const uint32_t product = (a >> 8) * (reciprocal >> 8) +
                                     (a >> 16) * (reciprocal & 0xff) +
                                     (a & 0xff) * (reciprocal >> 16);
            const int32_t component = static_cast<int32_t>(((product >> 13) + 1) >> 1);
            unit[i] = v[i] < 0 ? -component : component;
        }
    }
};

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR void normalise3(const Raw* v, Raw* unit) {
    Normalisation<Raw, F>::apply(v, unit);
}

}  // namespace portable
}  // namespace fixedpoint
