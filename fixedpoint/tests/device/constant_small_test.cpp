// SPDX-License-Identifier: MIT
// Functions of the small tier in constant expressions.
#include <fixedpoint/arithmetic/small.hpp>
#include <fixedpoint/math.hpp>

#include "constant.hpp"
#include "numbers.hpp"

using namespace fixedpoint;

namespace {

template <Raw A, Raw B>
void check_functions() {
    CHECK_CONSTANT(sqrt(as<Small>(x)));
    CHECK_CONSTANT(reciprocal_sqrt(as<Small>(x)));
    CHECK_CONSTANT(atan(as<Small>(x)));
    CHECK_CONSTANT(atan2(as<Small>(x), as<Small>(y)));
    CHECK_CONSTANT(sin(as<Small>(x)));
    CHECK_CONSTANT(cos(as<Small>(x)));
    CHECK_CONSTANT(exp(as<Small>(x)));
    CHECK_CONSTANT(log(as<Small>(x)));
    CHECK_CONSTANT(as<Small>(x) / as<Small>(y));
}

}  // namespace

void test_constant_small() {
    check_functions<third, fifth>();
    check_functions<above_one, below_one>();
}
