#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes src/fixedpoint/avr/sin_polynomial.inc, the coefficients of sin_q16_16_small.S: the odd
polynomial of least largest error on [0, 1], by the exchange algorithm (Evgeny Remez, 1934), as
24-bit fractions, with the error that it leaves."""

from math import pi, sin

import page

GRID = 20000


def solve(rows):
    """The solution of a system of linear equations; the last entry of a row is its right side."""
    rows = [row[:] for row in rows]
    for i in range(len(rows)):
        pivot = max(range(i, len(rows)), key=lambda r: abs(rows[r][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for r in range(len(rows)):
            if r != i:
                factor = rows[r][i] / rows[i][i]
                rows[r] = [a - factor * b for a, b in zip(rows[r], rows[i])]
    return [row[-1] / row[i] for i, row in enumerate(rows)]


def minimax(function, terms):
    """Coefficients of x, x^3, ... and the largest error."""
    points = [sin(pi / 2 * (k + 0.5) / (terms + 0.5)) for k in range(terms)] + [1.0]
    for _ in range(20):
        *coefficients, error = solve(
            [[x**(2 * j + 1) for j in range(terms)] + [(-1)**k, function(x)]
             for k, x in enumerate(points)])

        def deviation(x):
            return abs(function(x) - sum(c * x**(2 * j + 1) for j, c in enumerate(coefficients)))

        size = [deviation(i / GRID) for i in range(GRID + 1)] + [0.0]
        extremes = [i / GRID for i in range(1, GRID + 1)
                    if size[i] >= size[i - 1] and size[i] > size[i + 1]]
        points = extremes[-(terms + 1):]
    return coefficients, abs(error)


if __name__ == "__main__":
    coefficients, error = minimax(lambda x: sin(pi / 2 * x) / 2, 4)
    lines = ["// SPDX-License-Identifier: MIT",
             "// DO NOT EDIT: written by python3 fixedpoint/tables/minimax.py",
             "// sin(pi/2 x) / 2 = x (C0 - x^2 (C1 - x^2 (C2 - ...))) / 2^24, within "
             f"{error:.1e}",
             *(f"#define C{i} {round(abs(c) * 2**24)}" for i, c in enumerate(coefficients))]
    (page.SOURCE / "avr/sin_polynomial.inc").write_text("\n".join(lines) + "\n")
