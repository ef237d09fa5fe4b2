// SPDX-License-Identifier: MIT
// Sines of turns and degrees, and the angles of vectors: the kernels return what the compiler
// computes from the portable code, which is tested on the host; quarter turns are exact.
#include <fixedpoint/angle.hpp>

#include "numbers.hpp"

using namespace fixedpoint;

namespace {

constexpr Raw angle_of_row(uint16_t i) {
    return static_cast<Raw>(static_cast<Raw>(static_cast<uint64_t>(i) * 0x9e3779b97f4a7c15) >>
                            (i % 5));
}

// A constant of the compiler, and the same at run time.
template <uint16_t i>
struct SinesOf {
    static constexpr Number angle = Number::from_raw(angle_of_row(i));
    static constexpr Raw sine = sin_turns(angle).raw(), cosine = cos_turns(angle).raw();
    static void check() {
        const Number x = operand(angle_of_row(i));
        CHECK(sin_turns(x).raw() == sine);
        CHECK(cos_turns(x).raw() == cosine);
        CHECK(sincos_turns(x).sine.raw() == sine && sincos_turns(x).cosine.raw() == cosine);
        SinesOf<i - 1>::check();
    }
};
template <>
struct SinesOf<0> {
    static void check() {}
};

// 1, saturated if need be, -1 and 0.
Raw of_quadrant(uint8_t quadrant) {
    const int8_t sign = quadrant % 2 == 0 ? 0 : quadrant == 1 ? 1 : -1;
    return convert_checked<Number>(sign).number.raw();
}

template <class Angle, class Sine>
void check_quarters(Angle angle, Sine sine) {
    for (uint8_t quarters = 0; quarters < 8; ++quarters)
        CHECK(sine(angle(quarters)).raw() == of_quadrant(quarters % 4));
}

}  // namespace

void test_angles() {
    SinesOf<40>::check();
    check_quarters([](uint8_t quarters) { return Turn<16>::from_raw(0x4000) * quarters; },
                   [](Turn<16> angle) { return sin<Number>(angle); });
    check_quarters([](uint8_t quarters) { return Turn<32>::from_raw(0x40000000) * (quarters - 1); },
                   [](Turn<32> angle) { return cos<Number>(angle); });
    // The axes, if the format can represent the angle.
    const Number one = operand(1), zero = operand(0);
    const Raw quarter = static_cast<Raw>((int64_t(1) << FRACTION_BITS) / 4);
    CHECK(FRACTION_BITS < 2 || atan2_turns(one, zero).raw() == quarter);
    CHECK(FRACTION_BITS < 2 || atan2_turns(-one, zero).raw() == -quarter);
    CHECK(atan2_turns(zero, one).raw() == 0 && atan2_turns(zero, zero).raw() == 0);
    CHECK(atan2_degrees(-one, zero) == convert_checked<Number>(-90).number);
    for (int16_t degrees = -720; degrees <= 720; degrees += 90) {
        if (!convert_checked<Number>(degrees).fits) continue;
        const Number x = operand(convert_checked<Number>(degrees).number.raw());
        CHECK(sin_degrees(x).raw() == of_quadrant(static_cast<uint8_t>((degrees + 720) / 90 % 4)));
    }
}
