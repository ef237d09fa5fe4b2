// SPDX-License-Identifier: MIT
// The raw of a float or an integer that the compiler knows: a constant expression in every
// standard, unless the value is out of range.
#pragma once

#include <fixedpoint/builtin.hpp>
#include <fixedpoint/portable/convert.hpp>

// C++20 always evaluates such a function at compile time. Before C++20, an optimising compiler
// rejects a call of the error function that is left over; without optimisation, the program stops
// there.
#if __cplusplus >= 202002L
#define FIXEDPOINT_CONSTEVAL consteval
#else
#define FIXEDPOINT_CONSTEVAL constexpr __attribute__((always_inline)) inline
#endif

namespace fixedpoint {
namespace portable {

#ifdef __OPTIMIZE__
__attribute__((error("fixed takes a constant that the format can represent"))) int64_t
the_format_does_not_hold_this_constant();
#else
inline int64_t the_format_does_not_hold_this_constant() { __builtin_trap(); }
#endif

template <class Raw, int F, BuiltinKind kind>
struct Constant {
    static_assert(kind == BuiltinKind::integer || kind == BuiltinKind::floating_point,
                  "fixed takes an integer, float or double.");
};
template <class Raw, int F>
struct Constant<Raw, F, BuiltinKind::integer> {
    // In words that can represent every integer: a call to a function that is not inlined would
    // leave the error function in.
    template <class Int>
    static FIXEDPOINT_CONSTEVAL Raw raw(Int n) {
        return (n < Int(1) ? static_cast<int64_t>(n) >=
                                 static_cast<int64_t>(shift_down<F>(RawLimits<Raw>::min))
                           : static_cast<uint64_t>(n) <=
                                 static_cast<uint64_t>(shift_down<F>(RawLimits<Raw>::max)))
                   ? scale<Raw, F>(n)
                   : static_cast<Raw>(the_format_does_not_hold_this_constant());
    }
};
template <class Raw, int F>
struct Constant<Raw, F, BuiltinKind::floating_point> {
    using Whole = typename IntegerWithSign<64, RawLimits<Raw>::is_signed>::Type;
    // 2^bits
    template <class Float>
    static FIXEDPOINT_CONSTEVAL Float power(int bits) {
        return static_cast<Float>(uint64_t(1) << (bits / 2)) *
               static_cast<Float>(uint64_t(1) << (bits - bits / 2));
    }
    // floor(ulps + 1/2), given `whole`, which is ulps truncated.
    template <class Float>
    static FIXEDPOINT_CONSTEVAL Whole rounded(Float ulps, Whole whole) {
        return ulps - static_cast<Float>(whole) >= Float(0.5)   ? whole + 1
               : ulps - static_cast<Float>(whole) < -Float(0.5) ? whole - 1
                                                                : whole;
    }
    // If a Float does not distinguish the limit from half an ulp beyond it, it does not have a
    // number between the two. Every comparison with NaN is false.
    template <class Float>
    static FIXEDPOINT_CONSTEVAL Raw raw_of_ulps(Float ulps) {
        return ulps < power<Float>(RawLimits<Raw>::width - RawLimits<Raw>::is_signed) -
                               Float(0.5) &&
                       ulps >= (RawLimits<Raw>::is_signed ? -power<Float>(RawLimits<Raw>::width - 1)
                                                          : Float(0)) -
                                   Float(0.5)
                   ? static_cast<Raw>(rounded(ulps, static_cast<Whole>(ulps)))
                   : static_cast<Raw>(the_format_does_not_hold_this_constant());
    }
    // Scaling x by a power of two is exact.
    template <class Float>
    static FIXEDPOINT_CONSTEVAL Raw raw(Float x) {
        return raw_of_ulps(x * power<Float>(F));
    }
};

}  // namespace portable
}  // namespace fixedpoint
