// SPDX-License-Identifier: MIT
// lerp: a + t (b - a) from the exact product, rounded once.
#pragma once

#include <fixedpoint/portable/double_word.hpp>

namespace fixedpoint {
namespace portable {

// The result modulo 2^W, whether it is the exact one, rounded, and if not, whether that is above
// the range.
template <class Raw>
struct Settled {
    Raw wrapped;
    bool fits;
    bool is_above;
};

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Settled<Raw> lerp(Raw a, Raw b, Raw t) {
    using Word = Unsigned<Raw>;
    using Parts = DoubleWordOf<Raw>;
    using Product = DoubleWord<Raw>;
    const bool negative = (b < a) != (t < 0);
    const Word distance = static_cast<Word>(b < a ? static_cast<Word>(a) - static_cast<Word>(b)
                                                  : static_cast<Word>(b) - static_cast<Word>(a));
    // At most (2^W - 1)^2; half an ulp more is still below 2^(2W).
    const uint8_t tie_is_lower = negative && F > 0;
    const Product half = static_cast<Product>(Product(uint8_t(F != 0)) << (F == 0 ? 0 : F - 1));
    const Product product =
        static_cast<Product>(static_cast<Product>(Parts::multiply(magnitude(t), distance) + half) -
                             Product(tie_is_lower));
    const Product ulps = static_cast<Product>(product >> F);
    const Word step = Parts::low(ulps);
    // The distance from a to the limit in the direction of the step.
    const Word room =
        static_cast<Word>(negative ? static_cast<Word>(a) - static_cast<Word>(RawLimits<Raw>::min)
                                   : static_cast<Word>(RawLimits<Raw>::max) - static_cast<Word>(a));
    const Raw signed_step = static_cast<Raw>(step);
    return {negative ? wrapping_subtract(a, signed_step) : wrapping_add(a, signed_step),
            Parts::high(ulps) == 0 && step <= room, !negative};
}

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw wrapping_lerp(Raw a, Raw b, Raw t) {
    return lerp<Raw, F>(a, b, t).wrapped;
}

}  // namespace portable
}  // namespace fixedpoint
