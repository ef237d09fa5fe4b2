#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/portable/pseudo_division_table.hpp: ln(1 + 2^-i) and ln 2, in
exact integer arithmetic, for working words of 32, 64 and 128 bits."""

from cordic import literal
from exponential_series import logarithm
from page import SOURCE

SENTENCE = """// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/pseudo_division.py
// ln(1 + 2^-i) for i = 1, 2, ... and ln 2, with Bits - 6 fraction bits of the working word.
#pragma once

#include <fixedpoint/portable/word128.hpp>

namespace fixedpoint {
namespace portable {

// A template, with Any = void, since its static members may be defined in a header.
template <class Word, class Any = void>
struct PseudoDivisionConstants;
"""


def table(word, bits, count):
    scale = bits - 6
    entries = [literal(logarithm((1 << i) + 1, 1 << i, scale), bits) for i in range(1, count + 1)]
    lines = ",\n".join("        " + entry for entry in entries)
    return f"""
template <class Any>
struct PseudoDivisionConstants<{word}, Any> {{
    static constexpr {word} logarithm[{count}] FIXEDPOINT_PROGRAM_MEMORY = {{
{lines}}};
    static constexpr {word} ln2() {{ return {literal(logarithm(2, 1, scale), bits)}; }}
}};
template <class Any>
constexpr {word} PseudoDivisionConstants<{word}, Any>::logarithm[];
"""


if __name__ == "__main__":
    # (F + 5) / 2 steps, for the largest number of fraction bits F that the word serves.
    text = SENTENCE + table("uint32_t", 32, 12) + table("uint64_t", 64, 28)
    text += table("Word128", 128, 34) + "\n}  // namespace portable\n}  // namespace fixedpoint\n"
    (SOURCE / "portable/pseudo_division_table.hpp").write_text(text)
