// SPDX-License-Identifier: MIT
// Numbers without a sign, of the same split and with fraction bits only: what kernels and the
// compiler make of each operation is what the portable code returns, which the host's tests compare
// with exact integers.
#include <fixedpoint/arithmetic/saturating.hpp>
#include <fixedpoint/math.hpp>
#include <fixedpoint/unsigned.hpp>
#include <fixedpoint/widening.hpp>

#include "numbers.hpp"

using namespace fixedpoint;

namespace {

constexpr int width = INTEGER_BITS + FRACTION_BITS;
using Word = UnsignedInteger<width>;

// Bytes and bits at which carries begin and end, and the neighbours of the limits.
const uint8_t patterns[] PROGMEM = {0x00, 0xff, 0x7f, 0x80, 0x55, 0xaa, 0x01, 0xfe, 0x93, 0x6c};
constexpr uint8_t operands = 3 * sizeof patterns;
__attribute__((noinline)) Word operand_of(uint8_t i) {
    const uint8_t pattern = pgm_read_byte(patterns + i / 3);
    // Each byte the same, the lower half only, or a single byte somewhere.
    Word word = 0;
    for (uint8_t byte = 0; byte < sizeof(Word); ++byte) {
        const bool counts = i % 3 == 0   ? true
                            : i % 3 == 1 ? byte < (sizeof(Word) + 1) / 2
                                         : byte == i / 3 % sizeof(Word);
        word = static_cast<Word>(static_cast<uint64_t>(word) << 8);
        if (counts) word = static_cast<Word>(word | pattern);
    }
    volatile Word hidden = word;
    return hidden;
}

template <int F>
__attribute__((noinline)) void check_pair(Word x, Word y, Word z) {
    using Number = UFixed<width - F, F>;
    using Saturated = UFixed<width - F, F, Saturating>;
    const Number a = Number::from_raw(x), b = Number::from_raw(y), c = Number::from_raw(z);
    CHECK((a * b).raw() == (portable::multiply<Word, F>(x, y)));
    CHECK((a / b).raw() == (portable::divide<Word, F>(x, y)));
    CHECK((a % b).raw() == (portable::remainder<Word, F>(x, y)));
    CHECK(multiply_add(a, b, c).raw() == (portable::multiply_add<Word, F>(x, y, z)));
    CHECK(lerp(a, b, c).raw() == (portable::wrapping_lerp<Word, F>(x, y, z)));
    CHECK((a + b).raw() == static_cast<Word>(x + y));
    CHECK((a - b).raw() == static_cast<Word>(x - y));
    CHECK(abs_diff(a, b).raw() == static_cast<Word>(x < y ? y - x : x - y));
    CHECK((a < b) == (x < y) && (a == b) == (x == y));
    const Saturated s = Saturated::from_raw(x), t = Saturated::from_raw(y);
    CHECK((s + t).raw() == portable::add_saturating(x, y));
    CHECK((s - t).raw() == portable::subtract_saturating(x, y));
    CHECK((s * t).raw() == (portable::multiply_saturating<Word, F>(x, y)));
    const auto division = divrem(a, b);
    CHECK(division.quotient ==
          (y == 0 ? (x == 0 ? Word(0) : Number::max().raw()) : static_cast<Word>(x / y)));
    CHECK(division.remainder == a % b);
}
template <int F>
__attribute__((noinline)) void check_single(Word x) {
    using Number = UFixed<width - F, F>;
    const Number a = Number::from_raw(x);
    CHECK(sqrt(a).raw() == (portable::sqrt<Word, F>(x)));
    CHECK(scale_down<3>(a).raw() == (portable::scale_down_plain<3>(x)));
    CHECK((a >> 200).raw() == 0 && (a << 200).raw() == 0);
    CHECK((a + 3).raw() == (portable::add_integer<Word, F>(x, 3)));
    CHECK(midpoint(a, a) == a);
    CHECK(floor(a) <= a && ceil(a) >= a);
}
template <int F>
void check() {
    for (row = 0; row < operands; ++row) {
        const Word x = operand_of(static_cast<uint8_t>(row));
        check_single<F>(x);
        for (uint8_t j = 0; j < operands; ++j) {
            check_pair<F>(x, operand_of(j), operand_of(static_cast<uint8_t>((row + j) % operands)));
        }
    }
    row = 0;
}

}  // namespace

void test_unsigned();
void test_unsigned() {
    check<(width == 64 && FRACTION_BITS == 0 ? 1 : FRACTION_BITS)>();
    check<(width == 64 ? 63 : width)>();
}
