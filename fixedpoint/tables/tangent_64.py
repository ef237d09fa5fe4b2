#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes avr/tangent_64_table.S and portable/tangent_64_table.hpp of fixedpoint/src/fixedpoint: the
tangents of the nodes from which the tangent of Q32.32 is computed."""

import page
import series
import table_header

NODES, BITS, SCALE = 202, 48, 128
SENTENCE = f"The tangents of i / 256, in units of 2^-{BITS}"


def tangent(i):
    sine, cosine = series.sine_and_cosine(i, 256, SCALE)
    return series.rounded((sine << SCALE) // cosine, SCALE - BITS)


if __name__ == "__main__":
    tangents = [tangent(i) for i in range(NODES)]
    assert tangents[-1] < 1 << BITS
    page.write_assembly(
        "tangent_64_table", "tangent_64.py", f"{SENTENCE}, the lowest byte first.",
        [("tangents", [byte for value in tangents for byte in value.to_bytes(BITS // 8, "little")])], alignment=1)
    table_header.write(
        "tangent_64_table", "tangent_64.py", f"{SENTENCE}.", "Tangent64Table",
        [("uint64_t", "tangent", tangents, "0x{:012x}")])
