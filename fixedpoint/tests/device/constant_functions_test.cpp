// SPDX-License-Identifier: MIT
// Functions in constant expressions.
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
    CHECK_CONSTANT(exp(x));
    CHECK_CONSTANT(log(x));
    CHECK_CONSTANT(multiply_add(x, y, y));
}

}  // namespace

void test_constant_functions() {
    check_functions<third, fifth>();
    check_functions<above_one, below_one>();
}
