// SPDX-License-Identifier: MIT
/// \file
/// Vector<Scalar, N>: N = 2 or 3 components, one after the other, with the operations of a physics
/// engine. Products of vectors round once if the scalar can.
#pragma once

#include <engine/inline.hpp>
#include <engine/scalar.hpp>

namespace engine {

/// \cond internal
// Calls function(i) for each component, without a loop: on the device that halves the cost of a
// vector operation.
template <int N, class Function>
ENGINE_INLINE void for_components(Function function) {
    function(0);
    function(1);
    if (N == 3) function(N - 1);
}

// The indices of a vector's components, as a parameter pack.
template <unsigned char... i>
struct Components {};
template <int N>
struct ComponentsOf {
    using List = Components<0, 1>;
};
template <>
struct ComponentsOf<3> {
    using List = Components<0, 1, 2>;
};
/// \endcond

/// A vector of two or three scalars, in the unit of the quantity.
template <class Scalar, int N>
struct Vector {
    static_assert(N == 2 || N == 3, "A vector has two or three components.");
    /// The components, x first.
    Scalar component[N];

    /// The zero vector.
    constexpr Vector() : Vector(typename ComponentsOf<N>::List()) {}
    /// The vector (x, y), from scalars or decimal constants.
    template <class X, class Y>
    constexpr Vector(X x, Y y) : component{scalar(x), scalar(y)} {
        static_assert(N == 2, "A vector of three components needs three arguments.");
    }
    /// The vector (x, y, z), from scalars or decimal constants.
    template <class X, class Y, class Z>
    constexpr Vector(X x, Y y, Z z) : component{scalar(x), scalar(y), scalar(z)} {
        static_assert(N == 3, "A vector of two components needs two arguments.");
    }
    /// Copies v, without setting the components to zero first, and without the byte loop that the
    /// device's compiler would make.
    ENGINE_INLINE Vector(const Vector& v) : Vector(v, typename ComponentsOf<N>::List()) {}
    /// Takes the components of v.
    ENGINE_INLINE Vector& operator=(const Vector& v) {
        for_components<N>([&](unsigned char i)
                              ENGINE_INLINE_LAMBDA { component[i] = v.component[i]; });
        return *this;
    }

    /// The component i, which must be less than N.
    /// @{
    FIXEDPOINT_CONSTEXPR Scalar& operator[](unsigned char i) { return component[i]; }
    constexpr const Scalar& operator[](unsigned char i) const { return component[i]; }
    /// @}

    /// Adds b, component by component.
    ENGINE_INLINE Vector& operator+=(const Vector& b) {
        for_components<N>([&](unsigned char i) ENGINE_INLINE_LAMBDA { component[i] += b[i]; });
        return *this;
    }
    /// Subtracts b, component by component.
    ENGINE_INLINE Vector& operator-=(const Vector& b) {
        for_components<N>([&](unsigned char i) ENGINE_INLINE_LAMBDA { component[i] -= b[i]; });
        return *this;
    }
    /// Multiplies each component by a scalar or a time step.
    template <class Factor>
    ENGINE_INLINE Vector& operator*=(Factor factor) {
        for_components<N>([&](unsigned char i)
                              ENGINE_INLINE_LAMBDA { component[i] = component[i] * factor; });
        return *this;
    }
    /// Adds b factor; each component is rounded once if the scalar can.
    ENGINE_INLINE Vector& add_scaled(const Vector& b, Scalar factor) {
        engine::add_scaled<N>(component, b.component, factor);
        return *this;
    }
    /// Adds the product of b and a time step, which is rounded.
    template <class TimeStep>
    ENGINE_INLINE Vector& add_scaled(Vector b, TimeStep dt) {
        return *this += b *= dt;
    }

    /// The sum, component by component.
    ENGINE_INLINE friend Vector operator+(const Vector& a, const Vector& b) {
        Vector sum(a);
        return sum += b;
    }
    /// The difference, component by component.
    ENGINE_INLINE friend Vector operator-(const Vector& a, const Vector& b) {
        Vector difference(a);
        return difference -= b;
    }
    /// The product with a scalar or a time step; each component is rounded once.
    template <class Factor>
    ENGINE_INLINE friend Vector operator*(const Vector& a, Factor factor) {
        Vector product(a);
        return product *= factor;
    }
    /// The opposite vector.
    ENGINE_INLINE Vector operator-() const {
        Vector negative;
        return negative -= *this;
    }

    /// Whether all components are equal.
    friend FIXEDPOINT_CONSTEXPR bool operator==(const Vector& a, const Vector& b) {
        for (unsigned char i = 0; i < N; ++i) {
            if (!(a[i] == b[i])) return false;
        }
        return true;
    }
    /// Whether any component differs.
    friend constexpr bool operator!=(const Vector& a, const Vector& b) { return !(a == b); }

  private:
    template <unsigned char... i>
    explicit constexpr Vector(Components<i...>) : component{(static_cast<void>(i), Scalar())...} {}
    template <unsigned char... i>
    ENGINE_INLINE Vector(const Vector& v, Components<i...>) : component{v[i]...} {}
    // By implicit conversion only: a Decimal has one, a raw integer does not.
    static constexpr Scalar scalar(Scalar x) { return x; }
};

/// The dot product, rounded once in fixed point. Overflows as the scalar does.
template <class Scalar, int N>
ENGINE_INLINE Scalar dot(const Vector<Scalar, N>& a, const Vector<Scalar, N>& b) {
    return dot<N>(a.component, b.component);
}

/// Adds v factor to a and subtracts the same product from b.
template <class Scalar, int N>
ENGINE_INLINE void exchange(Vector<Scalar, N>& a, Vector<Scalar, N>& b, const Vector<Scalar, N>& v,
                            Scalar factor) {
    exchange<N>(a.component, b.component, v.component, factor);
}

/// dot(n, u - v), rounded once in fixed point. Overflows as the scalar does.
template <class Scalar, int N>
ENGINE_INLINE Scalar dot_difference(const Vector<Scalar, N>& n, const Vector<Scalar, N>& u,
                                    const Vector<Scalar, N>& v) {
    return dot_difference<N>(n.component, u.component, v.component);
}

/// |v|^2. Overflows where the square does; length() does not.
template <class Scalar, int N>
ENGINE_INLINE Scalar squared_length(const Vector<Scalar, N>& v) {
    return square<N>(v.component);
}

/// |v|. In the default fixed-point arithmetic no square overflows, and a result that does not fit
/// saturates. For other scalars it overflows where the square does.
template <class Scalar, int N>
Scalar length(const Vector<Scalar, N>& v) {
    return length<N>(v.component);
}

/// v / |v|. The zero vector stays zero.
template <class Scalar, int N>
Vector<Scalar, N> normalise(const Vector<Scalar, N>& v) {
    return divided(v, length(v));
}

/// v / divisor. The zero vector if the divisor is zero.
template <class Scalar, int N>
ENGINE_INLINE Vector<Scalar, N> divided(const Vector<Scalar, N>& v, Scalar divisor) {
    if (divisor == Scalar()) return {};
    Vector<Scalar, N> quotient(v);
    for_components<N>([&](unsigned char i) ENGINE_INLINE_LAMBDA { quotient[i] /= divisor; });
    return quotient;
}

/// Whether no component is infinite or NaN.
template <class Scalar, int N>
ENGINE_INLINE bool is_finite(const Vector<Scalar, N>& v) {
    return is_finite(v[0]) && is_finite(v[1]) && is_finite(v[N - 1]);
}

/// The cross product. Each product is rounded.
template <class Scalar>
Vector<Scalar, 3> cross(const Vector<Scalar, 3>& a, const Vector<Scalar, 3>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// The third component of the cross product; the others are zero.
template <class Scalar>
Scalar cross(const Vector<Scalar, 2>& a, const Vector<Scalar, 2>& b) {
    return a[0] * b[1] - a[1] * b[0];
}

/// The products of the components. Each is rounded once.
template <class Scalar, int N>
Vector<Scalar, N> component_product(Vector<Scalar, N> a, const Vector<Scalar, N>& b) {
    for (unsigned char i = 0; i < N; ++i) a[i] *= b[i];
    return a;
}

}  // namespace engine
