#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes src/fixedpoint/avr/reciprocal_sqrt_q8_8_table.S and
src/fixedpoint/portable/reciprocal_sqrt_q8_8_table.hpp: chords of 2^20 / sqrt(m) for 16-bit m, with
32 intervals from 2^14 and 32 from 2^15 on and 256 positions f in each: value - (slope f >> 8).

A raw number a is m / 4^j, and the result is (value - (slope f >> 8)) 2^j / 256, rounded. The chord
of an interval minimises the largest error over all inputs in it."""

from math import isqrt

import page
import table_header

FRACTION = 20  # fraction bits of results in the search


def interval_and_position(a):
    """(j, interval, position)"""
    j = 0
    while a < 2**14:
        a, j = 4 * a, j + 1
    shift = 1 if a < 2**15 else 2
    return j, (a >> 8 + shift) - (32 if shift == 1 else 0), a >> shift & 255


def inputs():
    """For each interval, the (2^j, position, exact result) of all inputs in it."""
    intervals = [[] for _ in range(64)]
    for a in range(1, 2**15):
        j, interval, position = interval_and_position(a)
        intervals[interval].append((1 << j, position, isqrt(2**(24 + 2 * FRACTION) // a)))
    return intervals


def largest_error(points, value, slope, limit):
    largest = 0
    for factor, position, exact in points:
        result = (value - (slope * position >> 8)) * factor + 128 >> 8
        largest = max(largest, abs((result << FRACTION) - exact))
        if largest >= limit:
            break
    return largest


def chord(interval, points):
    first = 2**14 + 512 * interval if interval < 32 else 2**15 + 1024 * (interval - 32)
    last = first + (512 if interval < 32 else 1024)
    start, end = (isqrt(2**60 // m) / 2**10 for m in (first, last))
    best = (1 << 60, 0, 0)
    for slope in range(int(start - end) - 1, int(start - end) + 3):
        for value in range(int(start) - 2, int(start) + 4):
            error = largest_error(points, value, slope, best[0])
            if error < best[0]:
                best = (error, value, slope)
    return best


if __name__ == "__main__":
    chords = [chord(i, points) for i, points in enumerate(inputs())]
    values, slopes = ([row[k] for row in chords] for k in (1, 2))
    SENTENCE = "2^20 / sqrt(m) for 16-bit m."
    page.write_assembly("reciprocal_sqrt_q8_8_table", "reciprocal_sqrt_q8_8.py", SENTENCE, [
        ("value, high bytes", [value >> 8 for value in values]),
        ("value, low bytes", [value & 255 for value in values]), ("slope", slopes)])
    table_header.write("reciprocal_sqrt_q8_8_table", "reciprocal_sqrt_q8_8.py", SENTENCE,
                       "ReciprocalSqrtQ8_8Table",
                       [("uint16_t", "value", values, "{:4d}"), ("uint8_t", "slope", slopes, "{:3d}")])
