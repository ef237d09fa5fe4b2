#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/short_turns_table.S and portable/short_turns_table.hpp: the
angles whose tangents are short fractions, by which a tie is reduced."""

import page
import table_header
from series import arctangent, pi, rounded

BITS = 88  # the angles are below 1
LOWER = 24
GUARD = 8
# An angle of up to pi/4 + 2^-14 is atan(i / 16) + atan(j / 256) + atan(k / 4096) + atan(l / 65536)
# and a rest below 2^-16 (1 + 2^-20): the denominators, and the entries that suffice.
STAGES = ((16, 16), (256, 17), (4096, 16), (65536, 21))


def bytes_of(number):
    return [number >> 8 * i & 255 for i in range(BITS // 8)]


if __name__ == "__main__":
    half_pi = rounded(pi(BITS + GUARD), GUARD + 1) % (1 << BITS)
    groups = [(f"atan(i / {denominator})", [arctangent(i, denominator, BITS) for i in range(entries)])
              for denominator, entries in STAGES] + [("pi / 2 and pi", [half_pi, pi(BITS) % (1 << BITS)])]
    angles = [angle for _, group in groups for angle in group]
    sentence = ("The arcs of tangents i / " + ", i / ".join(str(denominator) for denominator, _ in STAGES) +
                f", pi / 2 and pi modulo 1,\nin units of 2^-{BITS}")
    page.write_assembly("short_turns_table", "short_turns.py", f"{sentence}, of {BITS // 8} bytes each.",
                        [(title, [byte for angle in group for byte in bytes_of(angle)]) for title, group in groups], 1)
    table_header.write(
        "short_turns_table", "short_turns.py",
        f"{sentence}: the upper bits and the lower {LOWER}; and how many there are of each tangent.", "ShortTurnsTable",
        [("uint64_t", "upper", [angle >> LOWER for angle in angles], "{:#018x}ull"),
         ("uint32_t", "lower", [angle & (1 << LOWER) - 1 for angle in angles], "{:#08x}u"),
         ("uint8_t", "entries", [entries for _, entries in STAGES], "{}")])
