// SPDX-License-Identifier: MIT
/// \file
/// Saturating: as Nearest, but every result out of range becomes the smallest or the largest
/// number, in the ring operations too. Operations of several steps (multiply_add, dot) saturate
/// each product and each sum.
#pragma once

#include <fixedpoint/arithmetic/nearest.hpp>
#include <fixedpoint/kernel/add_saturating.hpp>
#include <fixedpoint/kernel/dispatch.hpp>
#include <fixedpoint/portable/range.hpp>

namespace fixedpoint {

/// As Nearest, but nothing wraps: a result out of range becomes the smallest or the largest number.
struct Saturating : Nearest {
    /// Nothing is taken modulo 2^W.
    static constexpr bool is_modulo = false;

    /// a + b, saturated.
    template <class Raw, int F>
    static constexpr Raw add(Raw a, Raw b) {
        return kernel::add_saturating(a, b);
    }
    /// a - b, saturated.
    template <class Raw, int F>
    static constexpr Raw subtract(Raw a, Raw b) {
        return kernel::subtract_saturating(a, b);
    }
    /// -a; the negative of the smallest number is the largest. Without a sign, 0.
    template <class Raw, int F>
    static constexpr Raw negate(Raw a) {
        return !RawLimits<Raw>::is_signed ? Raw(0)
               : a == RawLimits<Raw>::min ? RawLimits<Raw>::max
                                          : static_cast<Raw>(-a);
    }
    /// a b rounded, saturated.
    template <class Raw, int F>
    static constexpr Raw multiply(Raw a, Raw b) {
        return kernel::multiply_saturating<Raw, F>(a, b);
    }
    /// The rounded and saturated a b, plus c, saturated.
    template <class Raw, int F>
    static constexpr Raw multiply_add(Raw a, Raw b, Raw c) {
        return add<Raw, F>(multiply<Raw, F>(a, b), c);
    }
    /// a[0] b[0] + a[1] b[1]; each product is rounded and saturated, and so is the sum: within 1
    /// ulp if nothing saturates.
    template <class Raw, int F>
    static constexpr Raw dot2(const Raw* a, const Raw* b) {
        return multiply_add<Raw, F>(a[1], b[1], multiply<Raw, F>(a[0], b[0]));
    }
    /// a[0] b[0] + a[1] b[1] + a[2] b[2], summed from the first on; each product is rounded and
    /// saturated, and so is each sum: within 1.5 ulp if nothing saturates.
    template <class Raw, int F>
    static constexpr Raw dot3(const Raw* a, const Raw* b) {
        return multiply_add<Raw, F>(a[2], b[2], dot2<Raw, F>(a, b));
    }
    /// `settle` needs more than the result mod 2^W.
    static constexpr bool settles = true;
    /// The exact result if it is in range, and otherwise the limit that it exceeds.
    template <class Raw>
    static constexpr Raw settle(Raw wrapped, bool fits, bool is_above, Operation) {
        return fits ? wrapped : is_above ? RawLimits<Raw>::max : RawLimits<Raw>::min;
    }
    /// a 2^count, saturated.
    template <class Raw, int F>
    static constexpr Raw shift_left(Raw a, unsigned char count) {
        return portable::shift_left_fits(a, count) ? Nearest::shift_left<Raw, F>(a, count)
                                                   : portable::limit_by_sign(a);
    }
    /// a, an integer or a raw of another format, rounded to F fraction bits, saturated.
    template <class Raw, int F, class FromRaw, int FromF>
    static constexpr Raw convert(FromRaw a) {
        return portable::convert_saturated<Raw, F, FromRaw, FromF>(a).number;
    }
};

}  // namespace fixedpoint
