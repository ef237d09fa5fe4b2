# SPDX-License-Identifier: MIT
"""The exponential function and the natural logarithm as integers scaled by a power of two, from
their series in exact integer arithmetic with 64 guard bits: the results are within 2^-32 of the
value times 2^bits."""

from series import GUARD, rounded


def exponential(numerator, denominator, bits):
    """e^(numerator/denominator) 2^bits; the denominator must be positive."""
    width = bits + GUARD
    term, total, k = 1 << width, 0, 0
    while term:
        total += term
        k += 1
        term = term * abs(numerator) // (denominator * k)
    return rounded((1 << 2 * width) // total if numerator < 0 else total, GUARD)


def logarithm(numerator, denominator, bits):
    """ln(numerator/denominator) 2^bits, for ratios from 1 to 2: twice the inverse hyperbolic
    tangent of (numerator - denominator) / (numerator + denominator)."""
    difference, sum_ = numerator - denominator, numerator + denominator
    power = (difference << bits + GUARD + 1) // sum_
    total, k = 0, 1
    while power:
        total += power // k
        power = power * difference**2 // sum_**2
        k += 2
    return rounded(total, GUARD)
