// SPDX-License-Identifier: MIT
// Saturating: as Nearest, but every result that does not fit is clamped to the smallest or the
// largest number, in the ring operations too.
#pragma once

#include <fixedpoint/arithmetic/nearest.hpp>
#include <fixedpoint/kernel/multiply_saturating.hpp>

namespace fixedpoint {

struct Saturating : Nearest {
    // a + b, clamped.
    template <class Raw, int F>
    static constexpr Raw add(Raw a, Raw b) {
        // An overflow has happened where both operands differ in sign from the wrapped sum.
        const Raw sum = wrapping_add(a, b);
        return ((a ^ sum) & (b ^ sum)) < 0 ? limit_by_sign(a) : sum;
    }
    // a - b, clamped.
    template <class Raw, int F>
    static constexpr Raw subtract(Raw a, Raw b) {
        const Raw difference = wrapping_subtract(a, b);
        return ((a ^ b) & (a ^ difference)) < 0 ? limit_by_sign(a) : difference;
    }
    // -a; the negative of the smallest number is the largest.
    template <class Raw, int F>
    static constexpr Raw negate(Raw a) {
        return a == raw_min<Raw> ? raw_max<Raw> : static_cast<Raw>(-a);
    }
    // a * b rounded, clamped.
    template <class Raw, int F>
    static constexpr Raw multiply(Raw a, Raw b) {
        return kernel::multiply_saturating<Raw, F>(a, b);
    }
    // a 2^count, clamped.
    template <class Raw, int F>
    static constexpr Raw shift_left(Raw a, unsigned char count) {
        const Raw shifted = Nearest::shift_left<Raw, F>(a, count);
        const bool fits =
            a == 0 || (count < width_of<Raw> && static_cast<Raw>(shifted >> count) == a);
        return fits ? shifted : limit_by_sign(a);
    }
    // a, of another format, rounded, clamped.
    template <class Raw, int F, class FromRaw, int FromF>
    static constexpr Raw convert(FromRaw a) {
        return portable::convert_clamped<Raw, F, FromRaw, FromF>(a).number;
    }

  private:
    template <class Raw>
    static constexpr Raw limit_by_sign(Raw a) {
        return a < 0 ? raw_min<Raw> : raw_max<Raw>;
    }
};

}  // namespace fixedpoint
