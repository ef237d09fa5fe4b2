// SPDX-License-Identifier: MIT
/// \file
/// The families of curves from a force sensor's reading to grams, evaluated in a scalar of the
/// caller's choice: Fixed with at least 16 integer and 16 fraction bits, float or double.
///
/// Coefficients are integers in units of 2^-16, which every such Fixed and double hold exactly.
/// They are scaled so that no important one is smaller than a few thousand units. `fixbench
/// calibrate` fits them; the curve that the firmware uses is in calibration_table.hpp. Evaluation
/// is always inlined, so that the coefficients of a constant curve are immediate operands and take
/// no RAM.
///
/// A curve takes the sum of 2^sum_bits readings, with sum_bits in 0..4, in place of their mean, so
/// that fractions of a count matter: near the end of the range a count is tens of grams.
#pragma once

#include <math.h>
#include <stdint.h>

#include <fixedpoint/math.hpp>
#include <fixedpoint/program_memory.hpp>

namespace firmware {
namespace calibration {

/// The number `raw` / 2^16 as a scalar.
template <class Scalar>
struct Constant {
    static constexpr Scalar of(int32_t raw) { return static_cast<Scalar>(raw) / 65536; }
};
template <int I, int F, class A>
struct Constant<fixedpoint::Fixed<I, F, A>> {
    static_assert(I >= 16 && F >= 16, "Grams need a format of at least 16:16 bits.");
    using Scalar = fixedpoint::Fixed<I, F, A>;
    using Raw = typename Scalar::Raw;
    static constexpr Scalar of(int32_t raw) {
        return Scalar::from_raw(static_cast<Raw>(raw) * (Raw{1} << (F - 16)));
    }
};

/// n 2^-exponent, exact in every Scalar. `exponent` must be at most 16, and `n` in 0..32767 >>
/// max(0, -exponent). On the chip a shift by 16 is free; one by another constant takes time for
/// each bit.
template <class Scalar, int exponent = 0>
constexpr Scalar scaled(int n) {
    return Constant<Scalar>::of(static_cast<int32_t>(n) << (16 - exponent));
}

/// A curve, limited to the readings `lowest` to `highest`, in which it rises and is positive and
/// below the sensor's range. A reading outside them counts as the nearest of the two, so that every
/// reading of a converter, even with a broken wire or a short circuit, yields a weight within
/// bounds. Poles lie outside.
template <class Curve>
struct Held {
    int16_t lowest, highest;
    Curve curve;

    template <class Scalar, int sum_bits = 0>
    [[gnu::always_inline]] FIXEDPOINT_CONSTEXPR Scalar grams(int sum) const {
        return curve.template grams<Scalar, sum_bits>(sum < lowest << sum_bits ? lowest << sum_bits
                                                      : sum > highest << sum_bits
                                                          ? highest << sum_bits
                                                          : sum);
    }
};

/// a x + b, computed in s = x / 1024.
struct Line {
    int32_t linear, constant;  ///< 2^10 a, b

    template <class Scalar, int sum_bits = 0>
    [[gnu::always_inline]] FIXEDPOINT_CONSTEXPR Scalar grams(int sum) const {
        const Scalar s = scaled<Scalar, 10 + sum_bits>(sum);
        return Constant<Scalar>::of(linear) * s + Constant<Scalar>::of(constant);
    }
};

/// x / (a x^2 + b x + c), the published Function 1. With s = x / 1024 it is computed as 32 x / (32
/// (2^20 a s^2 + 2^10 b s + c)), since a itself is less than one unit of 2^-16.
struct RationalQuadratic {
    int32_t square, linear, constant;  ///< 2^25 a, 2^15 b, 2^5 c

    template <class Scalar, int sum_bits = 0>
    [[gnu::always_inline]] FIXEDPOINT_CONSTEXPR Scalar grams(int sum) const {
        const Scalar s = scaled<Scalar, 10 + sum_bits>(sum);
        return scaled<Scalar, -5 + sum_bits>(sum) /
               ((Constant<Scalar>::of(square) * s + Constant<Scalar>::of(linear)) * s +
                Constant<Scalar>::of(constant));
    }
};

/// a x^2 + b x + c, the published Function 2, computed in s = x / 1024.
struct Quadratic {
    int32_t square, linear, constant;  ///< 2^20 a, 2^10 b, c

    template <class Scalar, int sum_bits = 0>
    [[gnu::always_inline]] FIXEDPOINT_CONSTEXPR Scalar grams(int sum) const {
        const Scalar s = scaled<Scalar, 10 + sum_bits>(sum);
        return (Constant<Scalar>::of(square) * s + Constant<Scalar>::of(linear)) * s +
               Constant<Scalar>::of(constant);
    }
};

/// o + w x / (p - x): the reading of a divider whose resistance is the sum of a constant part and a
/// part inversely proportional to the weight above a threshold o. Computed with one division, as (o
/// - w) + 4 ((w p / 4) / (p - x)), since w p exceeds 2^15.
struct Hyperbola {
    int32_t offset, numerator, pole;  ///< o - w, w p / 4, p

    template <class Scalar, int sum_bits = 0>
    [[gnu::always_inline]] FIXEDPOINT_CONSTEXPR Scalar grams(int sum) const {
        Scalar part = Constant<Scalar>::of(numerator) /
                      (Constant<Scalar>::of(pole << sum_bits) - scaled<Scalar>(sum));
        for (int i = 0; i < 2 + sum_bits; ++i) part = part + part;
        return Constant<Scalar>::of(offset) + part;
    }
};

/// o + e^(k + n ln g), where g = x / (1023 - x) is the conductance in units of the divider's.
struct ConductancePower {
    int32_t offset, logarithm, exponent;  ///< o, k, n

    template <class Scalar, int sum_bits = 0>
    [[gnu::always_inline]] FIXEDPOINT_CONSTEXPR Scalar grams(int sum) const {
        return sum <= 0 ? Constant<Scalar>::of(offset)
                        : Constant<Scalar>::of(offset) + above_offset<Scalar, sum_bits>(sum);
    }

  private:
    template <class Scalar, int sum_bits>
    [[gnu::always_inline]] constexpr Scalar above_offset(int sum) const {
        return exp(Constant<Scalar>::of(logarithm) +
                   Constant<Scalar>::of(exponent) *
                       log(scaled<Scalar>(sum) / scaled<Scalar>((1023 << sum_bits) - sum)));
    }
};

/// One piece of a curve that passes through every reading and is cubic between two of them: value +
/// t (slope + t (square + t cube)) with t = (x - first) / width.
struct CubicPiece {
    uint16_t first, width;
    uint32_t value, slope, square, cube;  ///< two's complement
};

struct MonotoneCubic {
    const CubicPiece* pieces;  ///< in program memory, in order of rising `first`
    int16_t count;

    template <class Scalar, int sum_bits = 0>
    Scalar grams(int sum) const {
        const CubicPiece* piece = pieces + count - 1;
        while (piece != pieces && sum < read_int(piece->first) << sum_bits) --piece;
        const Scalar t = scaled<Scalar>(sum - (read_int(piece->first) << sum_bits)) /
                         scaled<Scalar>(read_int(piece->width) << sum_bits);
        return read<Scalar>(piece->value) +
               t * (read<Scalar>(piece->slope) +
                    t * (read<Scalar>(piece->square) + t * read<Scalar>(piece->cube)));
    }

  private:
    static int read_int(const uint16_t& entry) {
        return static_cast<int>(fixedpoint::read_program_memory(entry));
    }
    template <class Scalar>
    static Scalar read(const uint32_t& entry) {
        return Constant<Scalar>::of(static_cast<int32_t>(fixedpoint::read_program_memory(entry)));
    }
};

}  // namespace calibration
}  // namespace firmware
