# SPDX-License-Identifier: MIT
"""Tables for linear interpolation on 256 intervals: a 24-bit value and a 16-bit slope for each. The
kernels read one byte from each page; portable code reads the same numbers from a header."""

from fractions import Fraction

import page
import table_header

INTERVALS = 256
# Products of slope and fraction are truncated to whole units in three places, on average by 1.5
# units.
CUT = Fraction(3, 2)


def chords(function, offset):
    """(value, slope) for each interval of [0, 1], in units of the table: chords of `function`
    (which takes the position as numerator and denominator), moved by half of their distance from
    the curve, plus `offset` units. The slopes of a falling function are negated: the kernel
    subtracts."""
    rows = []
    for i in range(INTERVALS):
        left = function(2 * i, 2 * INTERVALS)
        middle = function(2 * i + 1, 2 * INTERVALS)
        right = function(2 * i + 2, 2 * INTERVALS)
        centring = (middle - (left + right) / 2) / 2
        rising = right >= left
        cut = CUT if rising else -CUT
        value = min(int(left + centring + offset + cut + Fraction(1, 2)), (1 << 24) - 1)
        slope = min(int(abs(right - left) + Fraction(1, 2)), (1 << 16) - 1)
        rows.append((value, slope))
    return rows


def write(name, generator, sentence, rows, structure):
    """Writes avr/<name>.S and portable/<name>.hpp with the structure that contains the same
    numbers."""
    # The value's low byte comes last: the kernel loads it into the page register itself.
    page.write_assembly(name, generator, sentence, [
        ("slope, bits 0..7", [slope & 255 for _, slope in rows]),
        ("slope, bits 8..15", [slope >> 8 for _, slope in rows]),
        ("value, bits 8..15", [value >> 8 & 255 for value, _ in rows]),
        ("value, bits 16..23", [value >> 16 for value, _ in rows]),
        ("value, bits 0..7", [value & 255 for value, _ in rows])])
    table_header.write(name, generator, sentence, structure, [
        ("uint32_t", "value", [value for value, _ in rows], "0x{:06x}"),
        ("uint16_t", "slope", [slope for _, slope in rows], "0x{:04x}")])
