// SPDX-License-Identifier: MIT
// Functions of vectors and of several results in constant expressions.
#include <fixedpoint/math.hpp>

#include "constant.hpp"
#include "numbers.hpp"

using namespace fixedpoint;

namespace {

// Functions of vectors, as functions of the two numbers from which the vectors are built.
constexpr Number dot(Number x, Number y) {
    const Raw a[] = {x.raw(), y.raw(), x.raw()}, b[] = {y.raw(), y.raw(), x.raw()};
    return Number::from_raw(Nearest::dot3<Raw, FRACTION_BITS>(a, b));
}
constexpr Number length(Number x, Number y) {
    const Raw v[] = {x.raw(), y.raw(), x.raw()};
    return Number::from_raw(Nearest::length3<Raw, FRACTION_BITS>(v));
}
constexpr Number normalised(Number x, Number y, int component) {
    Raw v[] = {x.raw(), y.raw(), x.raw()};
    Nearest::normalise3<Raw, FRACTION_BITS>(v, v);
    return Number::from_raw(v[component]);
}
constexpr Number sincos(Number x, int component) {
    Raw sine_and_cosine[] = {0, 0};
    Nearest::sincos<Raw, FRACTION_BITS>(x.raw(), sine_and_cosine);
    return Number::from_raw(sine_and_cosine[component]);
}

template <Raw A, Raw B>
void check_vectors() {
    CHECK_CONSTANT(dot(x, y));
    CHECK_CONSTANT(length(x, y));
    CHECK_CONSTANT(normalised(x, y, 0));
    CHECK_CONSTANT(normalised(x, y, 1));
    CHECK_CONSTANT(sincos(x, 0));
    CHECK_CONSTANT(sincos(x, 1));
}

}  // namespace

void test_constant_vectors() {
    check_vectors<third, fifth>();
    check_vectors<above_one, below_one>();
}
