// SPDX-License-Identifier: MIT
/// \file
/// watch(x, "speed") names a value of generic code for host/recorded.hpp. Of every other number it
/// is x itself, and costs nothing.
#pragma once

namespace fixedpoint {

/// \cond internal
template <class Number>
struct Watch {
    static constexpr const Number& of(const Number& x, const char*) { return x; }
};
/// \endcond

/// x. A Recorded number adds its value to the range of that name.
template <class Number>
constexpr const Number& watch(const Number& x, const char* name) {
    return Watch<Number>::of(x, name);
}

}  // namespace fixedpoint
