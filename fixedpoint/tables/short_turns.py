#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/short_turns_table.S: the angles whose tangents are short
fractions, which the kernel that compares an angle with a tie takes away from the tie."""

import page
from series import arctangent, pi, rounded

BITS = 88  # of 11 bytes; the angles are below 1
GUARD = 8
# An angle of up to pi/4 is atan(i / 16) + atan(j / 256) + atan(k / 4096) + atan(l / 65536) and a
# rest: of all ties of Q16.16, none needs more entries.
STAGES = ((16, 16), (256, 17), (4096, 16), (65536, 21))


def bytes_of(number):
    return [number >> 8 * i & 255 for i in range(BITS // 8)]


if __name__ == "__main__":
    half_pi = rounded(pi(BITS + GUARD), GUARD + 1) % (1 << BITS)
    stages = [(f"atan(i / {denominator})", [arctangent(i, denominator, BITS) for i in range(entries)])
              for denominator, entries in STAGES]
    page.write_assembly(
        "short_turns_table", "short_turns.py",
        f"Angles in units of 2^-{BITS}, modulo 1, of {BITS // 8} bytes each.",
        [(title, [byte for angle in angles for byte in bytes_of(angle)])
         for title, angles in (*stages, ("pi / 2 and pi", [half_pi, pi(BITS) % (1 << BITS)]))], 1)
