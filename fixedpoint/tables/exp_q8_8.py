#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes src/fixedpoint/avr/exp_q8_8_table.S and src/fixedpoint/portable/exp_q8_8_table.hpp: e^a in
Q8.8 as the power at a node times 1 + growth. Every 64th raw number from -1600 on is a node; its
power is in units of 2^-7 ulp. At the distance j = 0..63 from it the growth is 512 j + j (j + 5) +
more[j], in units of 2^-17, so only a byte of the series is stored.

A distance is shared by all nodes, and a node by all distances. In turn, each number is chosen among
the neighbours of its exact value so as to minimise the largest errors of the results that depend on
it."""

from fractions import Fraction

import page
import table_header
from exponential_series import exponential

FIRST, NODES, DISTANCES = -1600, 45, 64
LIMIT = 1243  # e^a overflows
LINEAR = 5    # and 512, per distance
BITS = 40
OFFSET = 104  # added to each growth so that `more` is not negative; powers are scaled down


def result(power, growth):
    """As the kernel computes it: products below the unit are omitted, except those of the next
    byte."""
    high, low = growth >> 8, growth & 255
    p2, p1, p0 = power >> 16, power >> 8 & 255, power & 255
    product = (p2 * high << 8) + p2 * low + p1 * high + (p1 * low >> 8) + (p0 * high >> 8)
    return 2 * power + product + 128 >> 8


def growth(distance, more):
    return 512 * distance + distance * (distance + LINEAR) + more


def improve(powers, more, exact):
    def error(node, distance, power, beyond):
        return abs(exact[node][distance] - (result(power, growth(distance, beyond)) << BITS))

    def worst(errors):
        return sorted(errors, reverse=True)[:4]

    for _ in range(3):
        for distance in range(DISTANCES):
            nodes = [n for n in range(NODES) if in_range(n, distance)]
            more[distance] = min(
                (b for b in range(more[distance] - 2, more[distance] + 3) if 0 <= b < 256),
                key=lambda b: worst(error(n, distance, powers[n], b) for n in nodes))
        for node in range(NODES):
            distances = [d for d in range(DISTANCES) if in_range(node, d)]
            powers[node] = min(range(powers[node] - 4, powers[node] + 5),
                               key=lambda p: worst(error(node, d, p, more[d]) for d in distances))


def in_range(node, distance):
    return FIRST + 64 * node + distance < LIMIT


def tables():
    exact = [[exponential(FIRST + 64 * node + j, 256, BITS + 8) for j in range(DISTANCES)]
             for node in range(NODES)]
    unit = Fraction(1, 2**17)
    powers = [round(Fraction(row[0], 2**(BITS - 7)) / (1 + OFFSET * unit)) for row in exact]
    factors = [Fraction(exponential(j, 256, BITS), 2**BITS) * (1 + OFFSET * unit) - 1
               for j in range(DISTANCES)]
    more = [round(factor / unit) - growth(j, 0) for j, factor in enumerate(factors)]
    improve(powers, more, exact)
    return powers, more


if __name__ == "__main__":
    powers, more = tables()
    SENTENCE = ("e^a at every 64th a in units of 2^-7 ulp, and the growth at each distance minus its\n"
                "quadratic part, in units of 2^-17.")
    page.write_assembly("exp_q8_8_table", "exp_q8_8.py", SENTENCE,
                        [("powers", [byte for power in powers for byte in power.to_bytes(3, "little")]),
                         ("growth", more)], alignment=1)
    table_header.write("exp_q8_8_table", "exp_q8_8.py", SENTENCE, "ExpQ8_8Table",
                       [("uint32_t", "power", powers, "{:8d}"), ("uint8_t", "growth", more, "{:3d}")])
