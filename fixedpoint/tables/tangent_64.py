#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/portable/tangent_64_table.hpp: the tangents of the nodes from
which the tangent of Q32.32 is computed."""

import series
import table_header

NODES, BITS, SCALE = 202, 48, 128


def tangent(i):
    sine, cosine = series.sine_and_cosine(i, 256, SCALE)
    return series.rounded((sine << SCALE) // cosine, SCALE - BITS)


if __name__ == "__main__":
    tangents = [tangent(i) for i in range(NODES)]
    assert tangents[-1] < 1 << BITS
    table_header.write(
        "tangent_64_table", "tangent_64.py",
        f"The tangents of i / 256, in units of 2^-{BITS}: the upper 32 bits and the lower 16.", "Tangent64Table",
        [("uint32_t", "upper", [value >> 16 for value in tangents], "0x{:08x}"),
         ("uint16_t", "lower", [value & 0xffff for value in tangents], "0x{:04x}")])
