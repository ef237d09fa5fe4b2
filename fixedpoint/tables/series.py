# SPDX-License-Identifier: MIT
"""Elementary functions as integers scaled by a power of two, from their series in exact integer
arithmetic with 64 guard bits: the results are within 2^-32 of the value times 2^bits."""

from math import isqrt

GUARD = 64


def _arctangent_of_inverse(n, bits):
    power = (1 << bits) // n
    total, k = 0, 0
    while power:
        total += -(power // (2 * k + 1)) if k & 1 else power // (2 * k + 1)
        power //= n * n
        k += 1
    return total


def _pi(bits):
    """John Machin, 1706."""
    return 16 * _arctangent_of_inverse(5, bits) - 4 * _arctangent_of_inverse(239, bits)


def rounded(value, surplus):
    """value / 2^surplus to nearest."""
    return (value + (1 << surplus >> 1)) >> surplus


def pi(bits):
    return rounded(_pi(bits + GUARD), GUARD)


def two_over_pi(bits):
    width = bits + GUARD
    return rounded((2 << 2 * width) // _pi(width), GUARD)


def _circular(angle, width, k):
    """The sine of angle / 2^width if k = 1, or its cosine if k = 0, in the same units."""
    square = angle * angle >> width
    term, total = angle if k else 1 << width, 0
    sign = 1
    while term:
        total += sign * term
        term = (term * square >> width) // ((k + 1) * (k + 2))
        sign, k = -sign, k + 2
    return total


def sine_of_quarter_turns(numerator, denominator, bits):
    """sin(pi/2 numerator/denominator) 2^bits, for arguments from 0 to 1."""
    width = bits + GUARD
    return rounded(_circular(_pi(width) * numerator // (2 * denominator), width, 1), GUARD)


def sine_and_cosine(numerator, denominator, bits):
    """sin(numerator/denominator) 2^bits and cos(numerator/denominator) 2^bits, for arguments from 0 to 1."""
    width = bits + GUARD
    angle = (numerator << width) // denominator
    return [rounded(_circular(angle, width, k), GUARD) for k in (1, 0)]


def circular(angle, denominator, bits):
    """sin(angle 2^-bits / denominator) 2^bits."""
    return rounded(_circular((angle << GUARD) // denominator, bits + GUARD, 1), GUARD)


def arctangent(numerator, denominator, bits):
    """atan(numerator/denominator) 2^bits, for arguments from 0 to 1, by the series of Euler:
    sum of 2^2n (n!)^2 / (2n+1)! x^(2n+1) / (1 + x^2)^(n+1), whose terms are all positive."""
    width = bits + GUARD
    squares = numerator * numerator + denominator * denominator
    term = (numerator * denominator << width) // squares
    total, n = 0, 0
    while term:
        total += term
        n += 1
        term = term * 2 * n * numerator * numerator // ((2 * n + 1) * squares)
    return rounded(total, GUARD)


def arc_sine(numerator, denominator, bits):
    """asin(numerator/denominator) 2^bits, for arguments from 0 to 1; those near 1 take long."""
    term = (numerator << bits + GUARD) // denominator
    total, k = 0, 1
    while term:
        total += term // k
        term = term * k * numerator**2 // ((k + 1) * denominator**2)
        k += 2
    return rounded(total, GUARD)


def rotation_gain(first, bits):
    """The product over i >= first of cos(atan(2^-i)) = 1 / sqrt(1 + 2^-2i), times 2^bits."""
    width = bits + GUARD
    product = 1 << width
    for i in range(first, width // 2 + 2):
        product = (product << width) // isqrt((1 << 2 * width) + (1 << 2 * (width - i)))
    return rounded(product, GUARD)
