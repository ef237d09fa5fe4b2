// SPDX-License-Identifier: MIT
/// \file
/// Observation: an arithmetic with a function `static void enter(Quantity)` is told, at the start
/// of each phase, which quantity a step works on, so that it can name what overflowed or vanished.
/// For every other scalar nothing is compiled.
#pragma once

#include <engine/inline.hpp>
#include <fixedpoint/fixed.hpp>

namespace engine {

/// What a step works on: the phases of World::step, in their order.
enum class Quantity : unsigned char {
    description,  ///< the numbers that a world is built from
    spring_force,
    drag_force,
    custom_force,
    velocity,
    position,
    damping,
    rod,
    rope,
    plane,
    contact,
    resolution,
};

/// \cond internal
template <class Scalar>
struct Observer {
    static ENGINE_INLINE void enter(Quantity) {}
};
template <int I, int F, class A>
struct Observer<fixedpoint::Fixed<I, F, A>> {
    static ENGINE_INLINE void enter(Quantity quantity) { tell<A>(quantity, 0); }

  private:
    // The first overload is used where the arithmetic has the function: for the argument 0, int is
    // the better match.
    template <class Arithmetic>
    static ENGINE_INLINE auto tell(Quantity quantity, int)
        -> decltype(Arithmetic::enter(quantity)) {
        Arithmetic::enter(quantity);
    }
    template <class Arithmetic>
    static ENGINE_INLINE void tell(Quantity, long) {}
};

template <class Scalar>
ENGINE_INLINE void observe(Quantity quantity) {
    Observer<Scalar>::enter(quantity);
}
/// \endcond

}  // namespace engine
