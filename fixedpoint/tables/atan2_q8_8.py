#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes src/fixedpoint/avr/atan2_q8_8_table.S and src/fixedpoint/portable/atan2_q8_8_table.hpp:
chords of the reciprocal and of the arc tangent, half a page each.

reciprocal i = 128..255: for d = 256 i + l, value - floor(slope l / 256) is 2^30 / d, always less and
as close as the chord allows.
angle i = 0..127: for T = 256 i + f, value + floor(slope f / 256) + T is 2^16 atan(T / 2^15) plus half
a unit, the mean truncation of the two.
"""

from fractions import Fraction

import page
import series

BITS = 60
HEADER = """// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/atan2_q8_8.py, which describes the entries.
#pragma once

#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {
namespace portable {

// A template, with Any = void, since its static members may be defined in a header.
template <class Any = void>
struct Atan2Q8_8Table {
"""


def reciprocal(index):
    first, last = 256 * index, 256 * index + 255
    slope = min(round(256 * Fraction(2**30 // first - 2**30 // (last + 1), 256)), 255)
    value = min((2**30 - 1) // (first + l) + (slope * l >> 8) for l in range(256))
    return value, slope


def angle(index):
    def excess(position):
        arctangent = Fraction(series.arctangent(position, 2**15, BITS), 2**(BITS - 16))
        return arctangent - position

    left, middle, right = (excess(256 * index + f) for f in (0, 128, 256))
    slope = min(int(right - left + Fraction(1, 2)), 255)
    centring = (middle - (left + right) / 2) / 2
    return int(left + centring + 1), slope


def array(kind, member, values):
    body = ",\n        ".join(page.rows(values))
    return (f"    static constexpr {kind} {member}[{len(values)}] FIXEDPOINT_PROGRAM_MEMORY = {{\n"
            f"        {body}}};\n")


if __name__ == "__main__":
    angles = [angle(i) for i in range(128)]
    reciprocals = [reciprocal(i) for i in range(128, 256)]
    rows = angles + reciprocals
    page.write_assembly("atan2_q8_8_table", "atan2_q8_8.py",
                        "Chords of the arc tangent (0..127) and of the reciprocal (128..255).", [
                            ("value, low bytes", [value & 255 for value, _ in rows]),
                            ("value, high bytes", [value >> 8 for value, _ in rows]),
                            ("slope", [slope for _, slope in rows])])
    members = [("uint16_t", "angle", [value for value, _ in angles]),
               ("uint8_t", "angle_slope", [slope for _, slope in angles]),
               ("uint16_t", "reciprocal", [value for value, _ in reciprocals]),
               ("uint8_t", "reciprocal_slope", [slope for _, slope in reciprocals])]
    text = HEADER + "".join(array(*member) for member in members) + "};\n"
    for kind, member, _ in members:
        text += f"template <class Any>\nconstexpr {kind} Atan2Q8_8Table<Any>::{member}[];\n"
    text += "\n}  // namespace portable\n}  // namespace fixedpoint\n"
    (page.SOURCE / "portable/atan2_q8_8_table.hpp").write_text(text)
