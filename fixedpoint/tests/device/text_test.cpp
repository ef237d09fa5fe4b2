// SPDX-License-Identifier: MIT
// Decimal text, and literals, which are decimal text read by the compiler.
#include <fixedpoint/literals.hpp>

#include "numbers.hpp"

using namespace fixedpoint;
using namespace fixedpoint::literals;

namespace {

void check_parse(const Parse& expected) {
    const Parsed<Number> result = parse<Number>(expected.text, strlen(expected.text));
    CHECK(result.number.raw() == expected.number);
    CHECK(result.status == expected.status);
    CHECK(result.position == expected.position);
}

void check_print(const Print& expected) {
    char buffer[sizeof expected.text];
    const size_t length = strlen(expected.text);
    const Number x = operand(expected.number);
    const auto print_into = [&](size_t capacity) {
        return expected.decimals < 0
                   ? print(x, buffer, capacity)
                   : print(x, static_cast<uint8_t>(expected.decimals), buffer, capacity);
    };
    CHECK(print_into(length - 1) == 0);
    CHECK(print_into(length) == length);
    CHECK(memcmp(buffer, expected.text, length) == 0);
    CHECK(length <=
          text_capacity<Number>(expected.decimals < 0 ? Number::fraction_bits : expected.decimals));
}

template <char... Text>
constexpr Fixed<8, 24> operator""_q8_24() {
    return literal<Fixed<8, 24>, Text...>();
}

// Both sides by hand: 0.38 2^16 = 24903.68, pi 2^32 = 13493037704.52.
void check_literals() {
    CHECK((0.38_q16_16).raw() == 24904);
    CHECK((-0.38_q16_16).raw() == -24904);
    CHECK((32767.99999_q16_16).raw() == INT32_MAX);
    CHECK((1'000.5_q16_16).raw() == 0x3e88000);
    CHECK((0.03125_q4_4).raw() == 1);
    CHECK((0.031249999999999999999999_q4_4).raw() == 0);
    CHECK((017_q8_8).raw() == 0x1100);
    CHECK((1e-3_q16_16).raw() == 66);
    CHECK((3.14159265358979323846_q32_32).raw() == 13493037705);
    CHECK((2147483647.9999999998_q32_32).raw() == INT64_MAX);
    CHECK((0.1_q8_24).raw() == 1677722);
}

}  // namespace

void test_text() {
    for_each(parses, check_parse);
    for_each(prints, check_print);
    check_literals();
}
