#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes src/fixedpoint/avr/sin_polynomial.inc, the constants of sin_q16_16_small.S: among the
integers near the coefficients of the polynomial without truncated products, which begins with
1 - pi^2 / 8, the two with the smallest spread of errors in the kernel's own arithmetic, and the
middle of that spread."""

from math import cos, pi

import page

UNIT = 1 << 24


def points(count):
    return [(parts(x), UNIT * (1 - cos(pi / 2 * (x + 0.5) / UNIT)))
            for x in (i * (UNIT - 1) // count for i in range(count + 1))]


def parts(x):
    """y, its upper bytes and y (1 - y): none depends on the constants."""
    x2, x1, x0 = x >> 16, x >> 8 & 255, x & 255
    y = (x2 * x2 << 8) + (x1 * x1 >> 8) + 2 * ((x2 * x0 >> 8) + x2 * x1)
    y2, y1 = y >> 16, y >> 8 & 255
    return y, y2, y1, y2 * (255 - y1) + y1 * (255 - y2) + (y2 * (255 - y2) << 8)


def missing(y, y2, y1, s, c0, c1):
    """The amount that the kernel subtracts from 1."""
    s2, s1, s0 = s >> 16, s >> 8 & 255, s & 255
    b = c0 - (y1 * (c1 >> 8) >> 8) - y2 * (c1 >> 8) - (y2 * (c1 & 255) >> 8) - s2
    b2, b1 = b >> 8, b & 255
    return y + ((s2 * b2 << 8) + (s1 * b1 >> 8) + (s0 * b2 >> 8) + s2 * b1 + s1 * b2 >> 2)


def extremes(values, c0, c1):
    errors = [exact - missing(*part, c0, c1) for part, exact in values]
    return max(errors) - min(errors), (max(errors) + min(errors)) / 2


if __name__ == "__main__":
    grid = points(4000)
    first = round((pi**2 / 8 - 1) * 2**18)
    _, c0, c1 = min((extremes(grid, c0, c1)[0], c0, c1)
                    for c0 in range(first, first + 16) for c1 in range(4998, 5014))
    bias = extremes(points(200000), c0, c1)[1]
    lines = ["// SPDX-License-Identifier: MIT",
             "// DO NOT EDIT: written by python3 fixedpoint/tables/sine_small.py",
             f"#define C0 {c0}", f"#define C1 {c1}", f"#define BIAS {round(bias)}"]
    (page.SOURCE / "avr/sin_polynomial.inc").write_text("\n".join(lines) + "\n")
