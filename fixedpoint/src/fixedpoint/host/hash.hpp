// SPDX-License-Identifier: MIT
// std::hash of fixed-point numbers: that of the raw integer.
#pragma once

#include <fixedpoint/fixed.hpp>
#include <functional>

template <int I, int F, class A>
struct std::hash<fixedpoint::Fixed<I, F, A>> {
    std::size_t operator()(fixedpoint::Fixed<I, F, A> number) const noexcept {
        return std::hash<fixedpoint::Integer<I + F>>()(number.raw());
    }
};
