// SPDX-License-Identifier: MIT
// Results of what has kernels in assembly.
#include <fixedpoint.h>

#include "show.hpp"

using namespace fixedpoint;

template <class Number>
static void show_all() {
    // Not known to the compiler, so that the kernels run.
    volatile typename Number::Raw three = 3 * (1ll << Number::fraction_bits) + 1;
    volatile typename Number::Raw seven = -7 * (1ll << Number::fraction_bits) / 5;
    const Number a = Number::from_raw(three), b = Number::from_raw(seven);
    show("product", a * b);
    show("quotient", a / b);
    show("root", sqrt(a));
    show("angle", atan2(b, a));
}

int main() {
    begin();
    show_all<Q4_4>();
    show_all<Q8_8>();
    show_all<Q16_16>();
    show_all<Q32_32>();
    end();
}
