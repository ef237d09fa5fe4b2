#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/portable/elementary_table.hpp: the constants that convert
natural logarithms to other bases, in exact integer arithmetic, for working words of 32, 64 and 128
bits."""

import series
from cordic import literal
from exponential_series import logarithm
from page import SOURCE

HEAD = """// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/elementary.py
// log10(2) with Bits - 6 fraction bits of the working word; 1/ln 2 and 1/ln 10 with Bits - 1; 1/3
// with Bits. half_pi_excess is CordicConstants<Word128>::half_pi - pi/2, with 190 fraction bits.
#pragma once

#include <fixedpoint/portable/word128.hpp>

namespace fixedpoint {
namespace portable {

template <class Word>
struct ElementaryConstants;
"""
GUARD = 80


def ratio(numerator, denominator, bits):
    """numerator / denominator 2^bits to nearest."""
    return ((numerator << bits + 1) // denominator + 1) >> 1


def table(word, bits):
    scale = bits + GUARD
    ln2 = logarithm(2, 1, scale)
    ln10 = 3 * ln2 + logarithm(10, 8, scale)
    one = 1 << scale
    return f"""
template <>
struct ElementaryConstants<{word}> {{
    static constexpr {word} log10_of_2() {{ return {literal(ratio(ln2, ln10, bits - 6), bits)}; }}
    static constexpr {word} per_ln2() {{ return {literal(ratio(one, ln2, bits - 1), bits)}; }}
    static constexpr {word} per_ln10() {{ return {literal(ratio(one, ln10, bits - 1), bits)}; }}
    static constexpr {word} third() {{ return {literal(ratio(1, 3, bits), bits)}; }}
}};
"""


if __name__ == "__main__":
    excess = (series.pi(125) << 64) - series.pi(189)
    assert 0 < excess < 1 << 64
    text = HEAD + f"""
constexpr uint64_t half_pi_excess = {literal(excess, 64)};
""" + table("uint32_t", 32) + table("uint64_t", 64) + table("Word128", 128)
    (SOURCE / "portable/elementary_table.hpp").write_text(
        text + "\n}  // namespace portable\n}  // namespace fixedpoint\n")
