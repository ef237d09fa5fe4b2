// SPDX-License-Identifier: MIT
/// \file
/// Published: the arithmetic of the report that this project measures itself against, kept as the
/// baseline and for nothing else: truncation toward zero, products and quotients of magnitudes with
/// the sign put back, Turkowski's square root, an arc tangent by a table of 201 entries. Results
/// are taken modulo 2^W. What used to hang or return garbage is mended where it is defined.
#pragma once

#include <fixedpoint/arithmetic/wrapping.hpp>
#include <fixedpoint/published/atan2.hpp>
#include <fixedpoint/published/divide.hpp>
#include <fixedpoint/published/multiply.hpp>
#include <fixedpoint/published/sqrt.hpp>

namespace fixedpoint {

/// The arithmetic of the 2016 design: truncation toward zero, and the low W bits are kept.
struct Published : Wrapping {
    /// a b / 2^F toward zero, mod 2^W.
    template <class Raw, int F>
    static constexpr Raw multiply(Raw a, Raw b) {
        return published::multiply<Raw, F>(a, b);
    }
    /// a 2^F / b toward zero, mod 2^W; b = 0: the largest or smallest number by the sign of a, or
    /// 0.
    template <class Raw, int F>
    static constexpr Raw divide(Raw a, Raw b) {
        return published::divide<Raw, F>(a, b);
    }
    /// floor(sqrt(a 2^F)); 0 where a < 0.
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
