// SPDX-License-Identifier: MIT
// Functions in constant expressions.
#include <fixedpoint/arithmetic/small.hpp>
#include <fixedpoint/math.hpp>

#include "constant.hpp"
#include "numbers.hpp"

using namespace fixedpoint;

namespace {

template <Raw A, Raw B>
void check_functions() {
    CHECK_CONSTANT(sqrt(x));
    CHECK_CONSTANT(reciprocal_sqrt(x));
    CHECK_CONSTANT(atan(x));
    CHECK_CONSTANT(atan2(x, y));
    CHECK_CONSTANT(sin(x));
    CHECK_CONSTANT(cos(x));
    CHECK_CONSTANT(multiply_add(x, y, y));
}

template <Raw A, Raw B>
void check_small_functions() {
    CHECK_CONSTANT(sqrt(as<Small>(x)));
    CHECK_CONSTANT(reciprocal_sqrt(as<Small>(x)));
    CHECK_CONSTANT(atan2(as<Small>(x), as<Small>(y)));
    CHECK_CONSTANT(sin(as<Small>(x)));
    CHECK_CONSTANT(cos(as<Small>(x)));
}

}  // namespace

void test_constant_functions() {
    check_functions<third, fifth>();
    check_functions<above_one, below_one>();
    check_small_functions<third, fifth>();
    check_small_functions<above_one, below_one>();
}
