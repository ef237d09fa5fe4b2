// SPDX-License-Identifier: GPL-3.0-or-later
// The blocks as they are measured: each takes `inputs` numbers in -1..1 per step, multiplies them
// by `scale`, adds `offset`, and returns `outputs` numbers. The same source runs on the chip and on
// the host, for Fixed, float and double. Constants are multiples of 2^-8, which every format holds,
// so that only the arithmetic causes errors.
#pragma once

#include <fixedpoint/blocks/biquad.hpp>
#include <fixedpoint/blocks/complex.hpp>
#include <fixedpoint/blocks/interpolation.hpp>
#include <fixedpoint/blocks/matrix.hpp>
#include <fixedpoint/blocks/moving_average.hpp>
#include <fixedpoint/blocks/one_pole.hpp>
#include <fixedpoint/blocks/pid.hpp>
#include <fixedpoint/blocks/polynomial.hpp>
#include <fixedpoint/blocks/quaternion.hpp>

#include "bench/lab/catalogue/formats.h"

namespace blocks {

#define FORMAT_TYPE(name, I, F) using name = fixedpoint::Fixed<I, F>;
BLOCK_FORMATS(FORMAT_TYPE)
#undef FORMAT_TYPE
using binary32 = float;

// n / 2^Bits.
template <class Number, int Bits>
struct Constant {
    static constexpr Number of(long n) { return Number(n) / (1l << Bits); }
};
template <int I, int F, int Bits>
struct Constant<fixedpoint::Fixed<I, F>, Bits> {
    using Number = fixedpoint::Fixed<I, F>;
    static constexpr Number of(long n) {
        return Number::from_raw(static_cast<typename Number::Raw>(n * (1l << (F - Bits))));
    }
};
template <class Number>
constexpr Number constant(long n) {
    return Constant<Number, 8>::of(n);
}

// The format of a polynomial's coefficients: finer than that of its argument if there is a finer
// one.
template <class Number>
struct Finer {
    using Type = Number;
};
template <>
struct Finer<q8_8> {
    using Type = q16_16;
};
template <>
struct Finer<q16_16> {
    using Type = q8_24;
};

template <int Inputs, int Outputs>
struct Block {
    static constexpr int inputs = Inputs, outputs = Outputs;
    static constexpr int offset(int) { return 0; }
    static constexpr int scale = 1;
};
// The same block with inputs in -4..4, which in Q8.24 need the integer byte.
template <class Narrow>
struct Wide : Narrow {
    static constexpr int scale = 4;
};

template <class Number>
struct pid : Block<2, 1> {
    fixedpoint::Pid<Number> controller{
        {constant<Number>(384), constant<Number>(8), constant<Number>(128)},
        constant<Number>(-1024),
        constant<Number>(1024)};
    void step(const Number* in, Number* out) { *out = controller.update(in[0], in[1]); }
};
// Also with gains up to 8.
template <class Number>
struct pid_wide : Wide<Block<2, 1>> {
    fixedpoint::Pid<Number> controller{
        {constant<Number>(1984), constant<Number>(300), constant<Number>(896)},
        constant<Number>(-16384),
        constant<Number>(16384)};
    void step(const Number* in, Number* out) { *out = controller.update(in[0], in[1]); }
};
// A low-pass filter with a gain of 1 and poles of magnitude 0.91.
template <class Number>
struct biquad : Block<1, 1> {
    fixedpoint::Biquad<Number> filter{{constant<Number>(5), constant<Number>(10),
                                       constant<Number>(5), constant<Number>(-450),
                                       constant<Number>(214)}};
    void step(const Number* in, Number* out) { *out = filter.update(*in); }
};
// The high-pass filter with the opposite poles, whose a1 is positive.
template <class Number>
struct biquad_high_pass : Block<1, 1> {
    fixedpoint::Biquad<Number> filter{{constant<Number>(5), constant<Number>(-10),
                                       constant<Number>(5), constant<Number>(450),
                                       constant<Number>(214)}};
    void step(const Number* in, Number* out) { *out = filter.update(*in); }
};
// Coefficients up to 3.5.
template <class Number>
struct biquad_wide : Wide<Block<1, 1>> {
    fixedpoint::Biquad<Number> filter{{constant<Number>(640), constant<Number>(-900),
                                       constant<Number>(460), constant<Number>(-450),
                                       constant<Number>(214)}};
    void step(const Number* in, Number* out) { *out = filter.update(*in); }
};
template <class Number>
struct one_pole : Block<1, 1> {
    fixedpoint::OnePole<Number> filter{constant<Number>(5)};
    void step(const Number* in, Number* out) { *out = filter.update(*in); }
};
template <class Number>
struct moving_average : Block<1, 1> {
    fixedpoint::MovingAverage<Number, 16> filter;
    void step(const Number* in, Number* out) { *out = filter.update(*in); }
};
// Approximately sin(pi/2 x).
template <class Number>
struct polynomial : Block<1, 1> {
    using Coefficient = typename Finer<Number>::Type;
    static constexpr Coefficient c(long n) { return Constant<Coefficient, 16>::of(n); }
    void step(const Number* in, Number* out) {
        static const fixedpoint::Table<Coefficient, 6> coefficients FIXEDPOINT_PROGRAM_MEMORY = {
            {c(0), c(102921), c(0), c(-42218), c(0), c(4833)}};
        *out = fixedpoint::polynomial(*in, coefficients);
    }
};
template <class Number>
struct interpolation : Block<1, 1> {
    static constexpr Number c(long n) { return constant<Number>(n); }
    void step(const Number* in, Number* out) {
        static const fixedpoint::Table<Number, 17> sines FIXEDPOINT_PROGRAM_MEMORY = {
            {c(-256), c(-251), c(-237), c(-213), c(-181), c(-142), c(-98), c(-50), c(0), c(50),
             c(98), c(142), c(181), c(213), c(237), c(251), c(256)}};
        *out = fixedpoint::interpolate<-3>(sines, constant<Number>(-256), *in);
    }
};
template <class Number>
struct complex_product : Block<4, 2> {
    using Complex = fixedpoint::Complex<Number>;
    void step(const Number* in, Number* out) {
        fixedpoint::multiply(*reinterpret_cast<const Complex*>(in),
                             *reinterpret_cast<const Complex*>(in + 2),
                             *reinterpret_cast<Complex*>(out));
    }
};
template <class Number>
struct matrix_vector : Block<12, 3> {
    void step(const Number* in, Number* out) {
        fixedpoint::multiply(*reinterpret_cast<const fixedpoint::Matrix<Number, 3>*>(in),
                             *reinterpret_cast<const Number(*)[3]>(in + 9),
                             *reinterpret_cast<Number(*)[3]>(out));
    }
};
template <class Number, int N>
struct product : Block<2 * N * N, N * N> {
    using Matrix = fixedpoint::Matrix<Number, N>;
    void step(const Number* in, Number* out) {
        fixedpoint::multiply(*reinterpret_cast<const Matrix*>(in),
                             *reinterpret_cast<const Matrix*>(in + N * N),
                             *reinterpret_cast<Matrix*>(out));
    }
};
template <class Number>
struct matrix_product_2 : product<Number, 2> {};
template <class Number>
struct matrix_product_3 : product<Number, 3> {};
// For matrices with a large diagonal, so that they have an inverse.
template <class Number, int N>
struct inverse : Block<N * N, N * N> {
    using Matrix = fixedpoint::Matrix<Number, N>;
    static constexpr int offset(int i) { return i % (N + 1) == 0 ? 512 : 0; }
    void step(const Number* in, Number* out) {
        fixedpoint::invert(*reinterpret_cast<const Matrix*>(in), *reinterpret_cast<Matrix*>(out));
    }
};
template <class Number>
struct matrix_inverse_2 : inverse<Number, 2> {};
template <class Number>
struct matrix_inverse_3 : inverse<Number, 3> {};
// Applies the same rotation in every step, and keeps the length.
template <class Number>
struct quaternion_turn : Block<0, 4> {
    using Quaternion = fixedpoint::Quaternion<Number>;
    Quaternion turn{
        {constant<Number>(252), constant<Number>(32), constant<Number>(24), constant<Number>(21)}};
    Quaternion attitude{{constant<Number>(256), Number(), Number(), Number()}};
    void step(const Number*, Number* out) {
        attitude = fixedpoint::renormalised(turn * attitude);
        *reinterpret_cast<Quaternion*>(out) = attitude;
    }
};
template <class Number>
struct quaternion_rotate : Block<3, 3> {
    fixedpoint::Quaternion<Number> turn{{constant<Number>(128), constant<Number>(-128),
                                         constant<Number>(128), constant<Number>(128)}};
    void step(const Number* in, Number* out) {
        fixedpoint::rotate(turn, *reinterpret_cast<const Number(*)[3]>(in),
                           *reinterpret_cast<Number(*)[3]>(out));
    }
};

template <class Number>
struct one_pole_wide : Wide<one_pole<Number>> {};
template <class Number>
struct complex_product_wide : Wide<complex_product<Number>> {};
template <class Number>
struct matrix_vector_wide : Wide<matrix_vector<Number>> {};
template <class Number>
struct matrix_product_2_wide : Wide<matrix_product_2<Number>> {};
template <class Number>
struct matrix_product_3_wide : Wide<matrix_product_3<Number>> {};
template <class Number>
struct quaternion_rotate_wide : Wide<quaternion_rotate<Number>> {};

}  // namespace blocks
