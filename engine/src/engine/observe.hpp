// SPDX-License-Identifier: MIT
// Observation: which quantity a step works on, told to an arithmetic that wants to know, so that it
// can name what overflowed or vanished. `static void enter(Quantity)` of a scalar's Arithmetic is
// called at the head of each phase; every other scalar has no such function, and nothing is
// compiled.
#pragma once

#include <engine/inline.hpp>
#include <fixedpoint/fixed.hpp>

namespace engine {

enum class Quantity : unsigned char {
    description,  // the numbers that a world is built from
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

template <class Scalar>
struct Observer {
    static ENGINE_INLINE void enter(Quantity) {}
};
template <int I, int F, class A>
struct Observer<fixedpoint::Fixed<I, F, A>> {
    static ENGINE_INLINE void enter(Quantity quantity) { tell<A>(quantity, 0); }

  private:
    // The first where the arithmetic has the function: an int is the better match for 0.
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

}  // namespace engine
