// SPDX-License-Identifier: MIT
// Logarithms of the 64-bit formats with 31 to 52 fraction bits other than Q32.32, from the natural
// logarithm with 56.
#pragma once

#include <fixedpoint/kernel/dispatch.hpp>
#include <fixedpoint/portable/elementary.hpp>

namespace fixedpoint {
namespace kernel {
namespace fine {

using portable::Evaluation;
using portable::Outcome;

template <class Raw, int F>
constexpr bool serves() {
    return portable::is_fine_split<Raw, F>() && F <= 52;
}

// ln(a 2^-F) in units of 2^-56, within 1.2 units: 0.6 from the kernel and half a unit from the
// multiple of ln 2. a must not be 0.
template <int F>
FIXEDPOINT_CONSTEXPR int64_t natural_logarithm(uint64_t a) {
    constexpr int64_t ln2 = 49946518145322873, behind = 172;  // and behind / 256
    const bool is_long = a >> 63 != 0;
    const int64_t n = 56 - F + (is_long ? 1 : 0);
    return log_64<int64_t, 0>(static_cast<int64_t>(is_long ? a >> 1 : a), 56) + n * ln2 +
           ((n * behind + 128) >> 8);
}
// The logarithm to base b, given 1 / ln b in units of 2^-60.
template <int64_t per_ln_b>
struct LogarithmToBase {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Raw a) {
        constexpr int64_t factor = ((per_ln_b >> (52 - F)) + 1) >> 1;  // 2^-(F + 7)
        if (a <= 0) return portable::no_logarithm<Raw>();
        return {multiply_64<Raw, 0>(natural_logarithm<F>(static_cast<uint64_t>(a)), factor, 63),
                Outcome::in_range};
    }
};
struct Log2 : LogarithmToBase<1663314137230540311> {};
struct Log10 : LogarithmToBase<500707447518348173> {};

// As an unsigned number, 1 + a always fits.
struct Log1p {
    template <class Raw, int F>
    static FIXEDPOINT_IN_PLACE Evaluation<Raw> apply(Raw a) {
        constexpr uint64_t one = uint64_t(1) << F;
        if (a < 0 && magnitude(a) >= one) return portable::no_logarithm<Raw>();
        const int64_t natural = natural_logarithm<F>(one + static_cast<uint64_t>(a));
        return {(natural + (int64_t(1) << (55 - F))) >> (56 - F), Outcome::in_range};
    }
};

// The other functions are portable code.
using portable::Acos;
using portable::Asin;
using portable::Cbrt;
using portable::Cosh;
using portable::Exp2;
using portable::Expm1;
using portable::Pow;
using portable::Sinh;
using portable::Tan;
using portable::Tanh;

}  // namespace fine
}  // namespace kernel
}  // namespace fixedpoint
