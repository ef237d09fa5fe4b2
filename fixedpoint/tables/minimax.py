#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes src/fixedpoint/avr/sin_polynomial.inc, the coefficients of sin_q16_16_small.S: the odd
polynomial of least largest error on [0, 1], by the exchange algorithm (Evgeny Remez, 1934), in
powers of 1 - x^2, as fractions of 24 bits, the last of 16, with the error that it leaves."""

from math import comb, pi, sin

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


def in_distance_from_one(coefficients):
    """Those of 1, y, y^2 ..., y = 1 - z, of the polynomial whose are those of 1, z, z^2 ..."""
    return [(-1)**i * sum(comb(j, i) * c for j, c in enumerate(coefficients))
            for i in range(len(coefficients))]


if __name__ == "__main__":
    odd, error = minimax(lambda x: sin(pi / 2 * x) / 2, 4)
    rounded = [round(c * 2**24) for c in odd[:-1]] + [round(odd[-1] * 2**16) * 2**8]
    lines = ["// SPDX-License-Identifier: MIT",
             "// DO NOT EDIT: written by python3 fixedpoint/tables/minimax.py",
             "// sin(pi/2 x) / 2 = x (C0 + y (C1 + y (C2 + 2^8 y C3))) / 2^24, y = 1 - x^2, within "
             f"{error:.1e}",
             *(f"#define C{i} {c >> 8 * (i == 3)}"
               for i, c in enumerate(in_distance_from_one(rounded)))]
    (page.SOURCE / "avr/sin_polynomial.inc").write_text("\n".join(lines) + "\n")
