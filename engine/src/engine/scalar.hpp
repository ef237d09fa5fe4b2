// SPDX-License-Identifier: MIT
/// \file
/// What the engine requires of a scalar: the operators + - * / and comparisons, and the functions
/// in this file. A Fixed computes them with the library's operations that round once. Every other
/// type (float, double, a wide floating-point type) uses its operators and the sqrt of its own
/// namespace or of <math.h>.
#pragma once

#include <math.h>

#include <engine/inline.hpp>
#include <fixedpoint/arithmetic/saturating.hpp>
#include <fixedpoint/arithmetic/small.hpp>
#include <fixedpoint/conversion.hpp>
#include <fixedpoint/math.hpp>
#include <fixedpoint/vector.hpp>

namespace engine {

using fixedpoint::Fixed;

/// The scalar to begin with: nothing wraps, and a result that does not fit stays at the end of the
/// range, where it is easily seen. A plain Fixed wraps and takes fewer cycles: use it for scenes
/// whose numbers are known to fit.
template <int I, int F>
using SaturatingFixed = Fixed<I, F, fixedpoint::Saturating>;

/// The sum of a_i b_i over N components.
template <int N, class Scalar>
FIXEDPOINT_CONSTEXPR Scalar dot(const Scalar* a, const Scalar* b) {
    Scalar sum = a[0] * b[0];
    for (unsigned char i = 1; i < N; ++i) sum += a[i] * b[i];
    return sum;
}

/// The length of a vector of N components. For a scalar other than Fixed it overflows where the
/// square does.
template <int N, class Scalar>
Scalar length(const Scalar* v) {
    using ::sqrt;
    return sqrt(dot<N>(v, v));
}

/// a + b; of a Fixed, the nearest end of the range where the sum does not fit, since a value that
/// is too small is better than one of the wrong sign.
template <class Scalar>
constexpr Scalar saturating_sum(Scalar a, Scalar b) {
    return a + b;
}
/// \cond internal
template <int I, int F, class A>
constexpr Fixed<I, F, A> saturating_sum(Fixed<I, F, A> a, Fixed<I, F, A> b) {
    using Raw = typename Fixed<I, F, A>::Raw;
    return Fixed<I, F, A>::from_raw(fixedpoint::Saturating::template add<Raw, F>(a.raw(), b.raw()));
}
/// \endcond
/// a b; of a Fixed, the nearest end of the range where the product does not fit.
template <class Scalar>
constexpr Scalar saturating_product(Scalar a, Scalar b) {
    return a * b;
}
/// \cond internal
template <int I, int F, class A>
constexpr Fixed<I, F, A> saturating_product(Fixed<I, F, A> a, Fixed<I, F, A> b) {
    using Raw = typename Fixed<I, F, A>::Raw;
    return Fixed<I, F, A>::from_raw(
        fixedpoint::Saturating::template multiply<Raw, F>(a.raw(), b.raw()));
}
/// \endcond

/// a b. |a| must be less than 1/4, and 0 <= b < 2.
template <class Scalar>
ENGINE_INLINE Scalar short_product(Scalar a, Scalar b) {
    return a * b;
}
/// \cond internal
template <int I, int F>
ENGINE_INLINE Fixed<I, F, fixedpoint::Nearest> short_product(Fixed<I, F, fixedpoint::Nearest> a,
                                                             Fixed<I, F, fixedpoint::Nearest> b) {
    using Raw = typename Fixed<I, F, fixedpoint::Nearest>::Raw;
    return Fixed<I, F, fixedpoint::Nearest>::from_raw(
        fixedpoint::kernel::multiply_short<Raw, F>(a.raw(), b.raw()));
}
/// \endcond

/// a / b, with the result of the operator. In Q16.16 it uses the division that takes less flash and
/// more cycles.
template <class Scalar>
ENGINE_INLINE Scalar brief_quotient(Scalar a, Scalar b) {
    return a / b;
}
/// \cond internal
ENGINE_INLINE Fixed<16, 16> brief_quotient(Fixed<16, 16> a, Fixed<16, 16> b) {
    return Fixed<16, 16>::from_raw(fixedpoint::Small::divide<int32_t, 16>(a.raw(), b.raw()));
}
ENGINE_INLINE SaturatingFixed<16, 16> brief_quotient(SaturatingFixed<16, 16> a,
                                                     SaturatingFixed<16, 16> b) {
    return SaturatingFixed<16, 16>::from_raw(
        fixedpoint::Small::divide<int32_t, 16>(a.raw(), b.raw()));
}
/// \endcond

/// Whether a is neither infinite nor NaN. True of every Fixed.
template <class Scalar>
ENGINE_INLINE constexpr bool is_finite(Scalar a) {
    return a - a == Scalar();
}
/// \cond internal
template <int I, int F, class A>
constexpr bool is_finite(Fixed<I, F, A>) {
    return true;
}
/// \endcond

/// |a|. The smallest number of a wrapping format stays negative.
template <class Scalar>
constexpr Scalar absolute(Scalar a) {
    return a < Scalar() ? -a : a;
}

/// \cond internal
// An arithmetic without compound operations (Published) computes them from their parts, like every
// other scalar.
template <class Arithmetic>
struct RoundsOnce {
    template <class A>
    static char test(decltype(A::template dot2<int32_t, 16>(nullptr, nullptr))*);
    template <class A>
    static long test(...);
    static constexpr bool value = sizeof(test<Arithmetic>(nullptr)) == sizeof(char);
};

template <bool condition, class T>
struct OnlyIf {};
template <class T>
struct OnlyIf<true, T> {
    using Type = T;
};
template <int I, int F, class A>
using Compound = typename OnlyIf<RoundsOnce<A>::value, Fixed<I, F, A>>::Type;

template <int N, int I, int F, class A>
Compound<I, F, A> dot(const Fixed<I, F, A>* a, const Fixed<I, F, A>* b) {
    return N == 2 ? fixedpoint::dot2(a, b) : fixedpoint::dot3(a, b);
}
// In the engine the first factor is usually a direction.
template <int N, int I, int F>
ENGINE_INLINE Fixed<I, F, fixedpoint::Nearest> dot(const Fixed<I, F, fixedpoint::Nearest>* a,
                                                   const Fixed<I, F, fixedpoint::Nearest>* b) {
    using Number = Fixed<I, F, fixedpoint::Nearest>;
    using Raw = typename Number::Raw;
    return Number::from_raw(N == 2 ? fixedpoint::kernel::project2<Raw, F>(raws(a), raws(b))
                                   : fixedpoint::kernel::project3<Raw, F>(raws(a), raws(b)));
}
// The sum of v_i^2 over N components. Declared after the dot products that it calls.
template <int N, class Scalar>
FIXEDPOINT_IN_PLACE Scalar square(const Scalar* v) {
    return dot<N>(v, v);
}
template <int N, int I, int F>
ENGINE_INLINE Fixed<I, F, fixedpoint::Nearest> square(const Fixed<I, F, fixedpoint::Nearest>* v) {
    using Number = Fixed<I, F, fixedpoint::Nearest>;
    using Raw = typename Number::Raw;
    return Number::from_raw(N == 2 ? fixedpoint::kernel::square2<Raw, F>(raws(v))
                                   : fixedpoint::kernel::square3<Raw, F>(raws(v)));
}
template <int N, int I, int F, class A>
Compound<I, F, A> length(const Fixed<I, F, A>* v) {
    return N == 2 ? fixedpoint::length2(v) : fixedpoint::length3(v);
}
/// \endcond

/// a b + c. A Fixed uses fixedpoint::multiply_add, which rounds once. The engine calls its own
/// function with its namespace, since argument-dependent lookup of a plain multiply_add on Fixed
/// numbers finds the library's. A scalar that computes it otherwise specialises MultiplyAdd.
template <class Scalar>
struct MultiplyAdd {
    /// The value a b + c.
    static ENGINE_INLINE constexpr Scalar of(Scalar a, Scalar b, Scalar c) { return a * b + c; }
};
/// \cond internal
template <int I, int F, class A>
struct MultiplyAdd<Fixed<I, F, A>> {
    using Number = Fixed<I, F, A>;
    static ENGINE_INLINE constexpr Number of(Number a, Number b, Number c) {
        return sum<A>(a, b, c, 0);
    }

  private:
    // The first overload is used where the arithmetic rounds once: for the argument 0, int is the
    // better match.
    template <class Arithmetic>
    static ENGINE_INLINE constexpr Compound<I, F, Arithmetic> sum(Number a, Number b, Number c,
                                                                  int) {
        return fixedpoint::multiply_add(a, b, c);
    }
    template <class Arithmetic>
    static ENGINE_INLINE constexpr Number sum(Number a, Number b, Number c, long) {
        return a * b + c;
    }
};
/// \endcond
/// a b + c: rounded once for a Fixed, rounded by its operators for another scalar.
template <class Scalar>
ENGINE_INLINE constexpr Scalar multiply_add(Scalar a, Scalar b, Scalar c) {
    return MultiplyAdd<Scalar>::of(a, b, c);
}

/// Adds v factor to the vector `sum` of N components; each component is rounded once if the scalar
/// can.
template <int N, class Scalar>
void add_scaled(Scalar* sum, const Scalar* v, Scalar factor) {
    for (unsigned char i = 0; i < N; ++i) {
        sum[i] = engine::multiply_add(v[i], factor, sum[i]);
    }
}
/// Multiplies a vector of N components by a factor; each component is rounded once.
template <int N, class Scalar>
ENGINE_INLINE void scale(Scalar* v, Scalar factor) {
    v[0] = v[0] * factor;
    v[1] = v[1] * factor;
    if (N == 3) v[N - 1] = v[N - 1] * factor;
}
/// Adds v factor to a and subtracts the same product from b. a + b is unchanged to the last bit if
/// the scalar's sums are exact.
template <int N, class Scalar>
void exchange(Scalar* a, Scalar* b, const Scalar* v, Scalar factor) {
    for (unsigned char i = 0; i < N; ++i) {
        const Scalar product = v[i] * factor;
        a[i] += product;
        b[i] -= product;
    }
}
/// The dot product of n and u - v, of N components.
template <int N, class Scalar>
Scalar dot_difference(const Scalar* n, const Scalar* u, const Scalar* v) {
    Scalar difference[N];
    for (unsigned char i = 0; i < N; ++i) difference[i] = u[i] - v[i];
    return dot<N>(difference, n);
}
/// \cond internal
// The kernels of the default arithmetic provide these.
template <int N, int I, int F>
ENGINE_INLINE void add_scaled(Fixed<I, F, fixedpoint::Nearest>* sum,
                              const Fixed<I, F, fixedpoint::Nearest>* v,
                              Fixed<I, F, fixedpoint::Nearest> factor) {
    using Raw = typename Fixed<I, F, fixedpoint::Nearest>::Raw;
    if (N == 2) {
        fixedpoint::kernel::add_scaled2<Raw, F>(raws(sum), raws(v), factor.raw());
    } else {
        fixedpoint::kernel::add_scaled3<Raw, F>(raws(sum), raws(v), factor.raw());
    }
}
// Its kernel has a fast path for whole factors, such as 1 / length of a rod of 1/4 m. Computed as v
// + v (factor - 1).
template <int N>
ENGINE_INLINE void scale(Fixed<16, 16, fixedpoint::Nearest>* v,
                         Fixed<16, 16, fixedpoint::Nearest> factor) {
    add_scaled<N>(v, v, factor - Fixed<16, 16, fixedpoint::Nearest>::from_raw(int32_t(1) << 16));
}
template <int N, int I, int F>
ENGINE_INLINE void exchange(Fixed<I, F, fixedpoint::Nearest>* a,
                            Fixed<I, F, fixedpoint::Nearest>* b,
                            const Fixed<I, F, fixedpoint::Nearest>* v,
                            Fixed<I, F, fixedpoint::Nearest> factor) {
    using Raw = typename Fixed<I, F, fixedpoint::Nearest>::Raw;
    if (N == 2) {
        fixedpoint::kernel::exchange2<Raw, F>(raws(a), raws(b), raws(v), factor.raw());
    } else {
        fixedpoint::kernel::exchange3<Raw, F>(raws(a), raws(b), raws(v), factor.raw());
    }
}
template <int N, int I, int F>
ENGINE_INLINE Fixed<I, F, fixedpoint::Nearest> dot_difference(
    const Fixed<I, F, fixedpoint::Nearest>* n, const Fixed<I, F, fixedpoint::Nearest>* u,
    const Fixed<I, F, fixedpoint::Nearest>* v) {
    using Number = Fixed<I, F, fixedpoint::Nearest>;
    using Raw = typename Number::Raw;
    return Number::from_raw(
        N == 2 ? fixedpoint::kernel::dot_difference2<Raw, F>(raws(n), raws(u), raws(v))
               : fixedpoint::kernel::dot_difference3<Raw, F>(raws(n), raws(u), raws(v)));
}
/// \endcond

}  // namespace engine
