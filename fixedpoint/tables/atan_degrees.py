#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/portable/atan_degrees_table.hpp: the angles of the nodes from
which the angle of a vector in degrees is computed."""

import series
import table_header

NODES, BITS, SCALE = 64, 48, 128


def degrees(numerator, denominator):
    angle = 180 * series.arctangent(numerator, denominator, SCALE) << BITS
    return (2 * angle + series.pi(SCALE)) // (2 * series.pi(SCALE))


if __name__ == "__main__":
    table_header.write(
        "atan_degrees_table", "atan_degrees.py",
        f"The arc tangents of i / {NODES} in degrees, in units of 2^-{BITS}.", "AtanDegreesTable",
        [("uint64_t", "angle", [degrees(i, NODES) for i in range(NODES + 1)], "0x{:014x}")])
