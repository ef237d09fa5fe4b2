// SPDX-License-Identifier: MIT
/// \file
/// Published: the arithmetic of the 2016 design, kept only as a baseline for comparison. It
/// truncates toward zero, multiplies and divides magnitudes and then restores the sign, and uses
/// Turkowski's square root and an arc tangent from a table of 201 entries. Results are taken modulo
/// 2^W. Inputs for which the original hung or returned garbage are defined here.
#pragma once

#include <fixedpoint/arithmetic/wrapping.hpp>
#include <fixedpoint/published/atan2.hpp>
#include <fixedpoint/published/divide.hpp>
#include <fixedpoint/published/multiply.hpp>
#include <fixedpoint/published/sqrt.hpp>

namespace fixedpoint {

/// The arithmetic of the 2016 design: results are truncated toward zero and taken modulo 2^W.
struct Published : Wrapping {
    /// a b / 2^F toward zero, mod 2^W.
    template <class Raw, int F>
    static constexpr Raw multiply(Raw a, Raw b) {
        return published::multiply<Raw, F>(a, b);
    }
    /// a 2^F / b toward zero, mod 2^W; if b = 0, the largest number, the smallest one or 0, by the
    /// sign of a.
    template <class Raw, int F>
    static constexpr Raw divide(Raw a, Raw b) {
        return published::divide<Raw, F>(a, b);
    }
    /// floor(sqrt(a 2^F)); 0 if a < 0.
    template <class Raw, int F>
    static constexpr Raw sqrt(Raw a) {
        return published::sqrt<Raw, F>(a);
    }
    /// The angle of (x, y) in [0, 2 pi).
    template <class Raw, int F>
    static Raw atan2(Raw y, Raw x) {
        return published::atan2<Raw, F>(y, x);
    }
};

}  // namespace fixedpoint
