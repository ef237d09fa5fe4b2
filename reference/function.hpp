// SPDX-License-Identifier: GPL-3.0-or-later
// What each function of plain numbers is, once for every type in which it is computed: Real, where
// truth is wanted; double and long double, where the bulk judge is in a hurry; float, whose special
// cases are those of C's Annex F.
#pragma once

#include <cmath>
#include <stdexcept>

#include "reference/operation.hpp"

namespace reference {

// Precondition: the operands lie in the operation's domain, or Number has values for what does not.
// Inlined, since the bulk judge knows the operation at compile time.
template <class Number>
[[gnu::always_inline]] inline Number function(Operation operation, const Number* x) {
    using std::sqrt, std::atan, std::atan2, std::sin, std::cos, std::exp, std::log;
    switch (operation) {
        case Operation::sqrt:
            return sqrt(x[0]);
        case Operation::reciprocal_sqrt:
            return 1 / sqrt(x[0]);
        case Operation::atan:
            return atan(x[0]);
        case Operation::atan2:
            return atan2(x[0], x[1]);
        case Operation::sin:
            return sin(x[0]);
        case Operation::cos:
            return cos(x[0]);
        case Operation::exp:
            return exp(x[0]);
        case Operation::log:
            return log(x[0]);
        default:
            throw std::logic_error("an operation that is no function of plain numbers");
    }
}

}  // namespace reference
