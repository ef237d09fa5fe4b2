# SPDX-License-Identifier: MIT
"""Parabolas over the intervals of a table, as kernels of Q16.16 evaluate them at the fraction t of an
interval, in units of 2^-16:

    value + rise(slope, t) +- height(t) bend / 2^bits,

with `rise` and `height` of portable/interpolation.hpp."""

from fractions import Fraction

WHOLE = 1 << 16
CHECKED = 64


def rise(slope, t):
    t0, t1 = t & 255, t >> 8
    return (slope >> 8) * t1 + ((slope >> 8) * t0 >> 8) + ((slope & 255) * t1 >> 8)


def height(t):
    return (t >> 8) * (255 - (t >> 8)) >> 7


def parabola(exact, bits):
    """(value, slope, bend) of the curve exact(t). The bend counts upwards if the curve is above its
    chord, otherwise downwards. The value makes the largest errors of both signs equal."""
    left, middle, right = exact(0), exact(WHOLE // 2), exact(WHOLE)
    slope = round(right - left)
    over = middle - (left + right) / 2
    bend = round(abs(over) * (1 << bits - 7))
    sign = 1 if over > 0 else -1
    assert 0 <= slope < 1 << 16 and bend < 256
    errors = [exact(t) - rise(slope, t) - sign * (height(t) * bend >> bits)
              for t in range(0, WHOLE, WHOLE // CHECKED - 1)]
    return round(Fraction(max(errors) + min(errors)) / 2), slope, bend
