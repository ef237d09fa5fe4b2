#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/portable/cordic_table.hpp: atan(2^-i), pi, 2/pi and the gain of
the rotations, in exact integer arithmetic, for working words of 32, 64 and 128 bits."""

from pathlib import Path

import series

OUTPUT = Path(__file__).parent.parent / "src/fixedpoint/portable/cordic_table.hpp"


def literal(value, bits):
    if bits <= 64:
        return f"0x{value:0{bits // 4}x}" + ("u" if bits == 32 else "ull")
    high, low = divmod(value, 1 << 64)
    return f"Word128(0x{high:016x}ull, 0x{low:016x}ull)"


def table(word, bits, largest_fraction_bits):
    # atan(2^-i) differs from 2^-i by less than 1/96 ulp when 3 i >= F + 5.
    rotations = -(-(largest_fraction_bits + 5) // 3)
    scale = bits - 2
    entries = [series.arctangent(1, 1 << i, scale) for i in range(1, rotations + 1)]
    lines = ",\n".join("        " + literal(entry, bits) for entry in entries)
    return f"""
template <class Any>
struct CordicConstants<{word}, Any> {{
    static constexpr int largest_fraction_bits = {largest_fraction_bits};
    static constexpr int arctangent_count = {rotations};
    static constexpr {word} arctangent[{rotations}] FIXEDPOINT_PROGRAM_MEMORY = {{
{lines}}};
    static constexpr {word} pi() {{
        return {literal(series.pi(scale), bits)};
    }}
    static constexpr {word} gain() {{
        return {literal(series.rotation_gain(1, scale), bits)};
    }}
    static constexpr {word} two_over_pi() {{
        return {literal(series.two_over_pi(bits // 2), bits)};
    }}
    static constexpr {word} half_pi() {{
        return {literal(series.pi(scale - 1), bits)};
    }}
}};
template <class Any>
constexpr {word} CordicConstants<{word}, Any>::arctangent[];
"""


def main():
    OUTPUT.write_text("""// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/cordic.py
// atan(2^-i) for i = 1, 2, ..., pi, pi/2 and the gain of the rotations, the product of
// cos(atan(2^-i)), each with Bits - 2 fraction bits of the working word; 2/pi with Bits / 2.
#pragma once

#include <fixedpoint/portable/word128.hpp>

namespace fixedpoint {
namespace portable {

// A template, with Any = void, since its static members may be defined in a header.
template <class Word, class Any = void>
struct CordicConstants;
""" + table("uint32_t", 32, 20) + table("uint64_t", 64, 52) + table("Word128", 128, 63) + """
}  // namespace portable
}  // namespace fixedpoint
""")


if __name__ == "__main__":
    main()
