// SPDX-License-Identifier: MIT
/// \file
/// std::hash of fixed-point numbers: the hash of the raw integer.
#pragma once

#include <fixedpoint/fixed.hpp>
#include <functional>

template <int IntegerBits, int F, class A>
struct std::hash<fixedpoint::Fixed<IntegerBits, F, A>> {
    std::size_t operator()(fixedpoint::Fixed<IntegerBits, F, A> number) const noexcept {
        return std::hash<decltype(+number.raw())>()(number.raw());
    }
};
