#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes src/fixedpoint/avr/sin_q8_8_table.S and src/fixedpoint/portable/sin_q8_8_table.hpp: chords
of the sine of the first quarter turn, in 64 intervals.

A chord is the one with the smallest error among all results that it gives: of sines and cosines of
angles, whose phases are truncated as in sin_q8_8.inc, and of sines of phases. Those of angles are
in Q8.8 and in Q9.7, which rounds where Q8.8 does not; other formats round where one of them does.
"""

from fractions import Fraction

import chords_of_bytes
import series

INTERVALS = 64
UNIT_BITS = 4
HALF = 2**UNIT_BITS // 2  # an ulp of Q8.8
BITS = 24   # of an exact sine in ulp
WIDTH = 48  # of a fraction of a quarter turn
PHASE_OF_ONE = series.two_over_pi(30)
QUARTER_TURNS = series.two_over_pi(WIDTH + 32)  # in a radian


def signed(byte):
    return (byte ^ 128) - 128


def phase(angle, fraction_bits):
    turns = PHASE_OF_ONE + (1 << fraction_bits >> 1) >> fraction_bits  # in an ulp, times 2^32
    lowest = signed(turns & 255)
    turns = turns - lowest >> 8
    middle = signed(turns & 255)
    highest = turns - middle >> 8
    high, low = angle >> 8, angle & 255
    lower = abs(middle) * low >> 8
    return (highest * angle + middle * high + (-lower if middle < 0 else lower)
            + (lowest * high >> 8) & 0xffff)


def sine(quarter_turns):
    """In ulp and units of 2^-BITS of it, of an angle in units of 2^-WIDTH."""
    fraction = quarter_turns & (1 << WIDTH) - 1
    if quarter_turns >> WIDTH & 1:
        fraction = (1 << WIDTH) - fraction
    magnitude = series.sine_of_quarter_turns(fraction, 1 << WIDTH, BITS + 8)
    return -magnitude if quarter_turns >> WIDTH & 2 else magnitude


def results():
    """For each interval, (position, exact magnitude, bits below Q8.8's that are rounded off)."""
    of_interval = [[] for _ in range(INTERVALS)]

    def add(phase, exact, dropped):
        forward = phase & 0x7fff
        place = 0x7fff - forward if forward & 0x4000 else forward
        magnitude = -exact if phase & 0x8000 else exact
        of_interval[place >> 8].append((place & 255, magnitude, dropped))

    for number in range(-2**15, 2**15):
        for dropped in 0, 1:
            quarter_turns = number * QUARTER_TURNS >> 40 - dropped
            turned = quarter_turns + (1 << WIDTH)
            add(phase(number, 8 - dropped), sine(quarter_turns), dropped)
            add(phase(number, 8 - dropped) + 0x4000, sine(turned), dropped)
        add(number & 0xffff, sine(number << WIDTH - 14), 0)
    return of_interval


def largest_error(chord, places, limit):
    """Stops at `limit`."""
    value, slope = chord
    largest = 0
    for position, exact, dropped in places:
        rounded = value + (slope * position >> 8) + (HALF << dropped) - HALF
        result = rounded >> UNIT_BITS + dropped << dropped
        largest = max(largest, abs((result << BITS) - exact) >> dropped)
        if largest >= limit:
            break
    return largest


def chord(interval, places):
    def node(i):
        return Fraction(sine((i << WIDTH) // INTERVALS), 2**(BITS - UNIT_BITS))

    steepness = round(node(interval + 1) - node(interval))
    middle = round(node(interval)) + HALF
    best, limit = None, 2**BITS
    for slope in range(max(steepness - 4, 0), steepness + 5):
        for value in range(middle - 4, middle + 5):
            error = largest_error((value, slope), places, limit)
            if error < limit:
                best, limit = (value, slope), error
    return best


if __name__ == "__main__":
    chords_of_bytes.write("sin_q8_8_table", "sin_q8_8.py", "The sine of the first quarter turn.",
                          "SinQ8_8Table",
                          [chord(*entry) for entry in enumerate(results())], UNIT_BITS, 4)
