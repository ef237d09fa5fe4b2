// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/elementary.py
// log10(2) with Bits - 6 fraction bits of the working word; 1/ln 2 and 1/ln 10 with Bits - 1; 1/3
// with Bits. half_pi_excess is CordicConstants<Word128>::half_pi - pi/2, with 190 fraction bits.
#pragma once

#include <fixedpoint/portable/word128.hpp>

namespace fixedpoint {
namespace portable {

template <class Word>
struct ElementaryConstants;

constexpr uint64_t half_pi_excess = 0x6b7ed8fbbacc19c6ull;

template <>
struct ElementaryConstants<uint32_t> {
    static constexpr uint32_t log10_of_2() { return 0x01344135u; }
    static constexpr uint32_t per_ln2() { return 0xb8aa3b29u; }
    static constexpr uint32_t per_ln10() { return 0x3796f62au; }
    static constexpr uint32_t third() { return 0x55555555u; }
};

template <>
struct ElementaryConstants<uint64_t> {
    static constexpr uint64_t log10_of_2() { return 0x0134413509f79fefull; }
    static constexpr uint64_t per_ln2() { return 0xb8aa3b295c17f0bcull; }
    static constexpr uint64_t per_ln10() { return 0x3796f62a4dca1c65ull; }
    static constexpr uint64_t third() { return 0x5555555555555555ull; }
};

template <>
struct ElementaryConstants<Word128> {
    static constexpr Word128 log10_of_2() { return Word128(0x0134413509f79fefull, 0x311f12b35816f923ull); }
    static constexpr Word128 per_ln2() { return Word128(0xb8aa3b295c17f0bbull, 0xbe87fed0691d3e89ull); }
    static constexpr Word128 per_ln10() { return Word128(0x3796f62a4dca1c65ull, 0x4d56eaabeb4cf70dull); }
    static constexpr Word128 third() { return Word128(0x5555555555555555ull, 0x5555555555555555ull); }
};

}  // namespace portable
}  // namespace fixedpoint
