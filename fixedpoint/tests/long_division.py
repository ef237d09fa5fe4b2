# SPDX-License-Identifier: MIT
"""The digits of long_division.inc: the statements of the proofs at the point where it compares an
estimate.

u is three bytes, h the two that divide, 2^15 <= h; u < 2^8 h + 2^8. v is the reciprocal of h. Of the
estimate t, one byte, or 256, and u - t h, the lowest two bytes are there: M. Then one of these is so:

    u - t h = M          and M + h < 2^16, or the upper byte of M is less than q
    u - t h = M - 2^16   and it is at least -h, and the upper byte of M is at least q

where q is the number that the code compares with. So if it is less, M is right, and otherwise M +
h.
"""

from itertools import product

import numpy

from form import Form, known
from machine_code import demand
from stretches import equal

MANY = 1 << 90
QUOTIENT, DIGIT = 26, 27
# t - digit, and which of the cases above.
ESTIMATES = list(product((0, 256), ("fits", "below", "negative")))


def invert(m, h, inverse, idle):
    """The reciprocal floor((2^24 - 1) / h) - 2^8 of each h in its registers."""
    same = m.try_all(numpy.arange(1 << 15, 1 << 16), h, idle)

    def check(m, end):
        demand((m.number((inverse,)) == ((1 << 24) - 1) // m.given["tried"] - 256).all())
        same(m)
    return check


def hold_reciprocal(m, register, h, small):
    """`small`: it is 0."""
    if small:
        m.zero(register)
    else:
        m.hold(1, m.registers[register])
    left = known(1 << 24) - m.times(m.registers[register] + known(256), h)
    m.hold(1, left)
    m.hold(0, h - left)


def show_estimate(m, small, v, h, u2, u1, u0, low, high):
    """From the bytes of u, for M in the registers `high` and `low`."""
    u, upper, w = u2 * 65536 + u1 * 256 + u0, u2 * 256 + u1, known(65536) - h
    left = known(1 << 24) - m.times(v + known(256), h)
    m.possible([])
    m.learn((0, h - upper, MANY))
    for one, other in ((h - upper, v + known(256)), (h - upper, h), (h - left, u2), (left, u2), (w, known(32768) - w)):
        m.hold(0, m.times(one, other))
    if small:
        m.learn((0, w, 255))
    else:
        m.hold(0, m.times(v - known(1), h))
        m.learn((0, w * 256 - h, MANY))
        m.hold(0, m.times(w * 256 - h, known(255) - u1))
    q, digit = m.registers[QUOTIENT], m.registers[DIGIT]
    t = Form({name: 1 for name in digit if str(name).startswith("byte")}) + known(1)
    m.bring(h)
    m.learn((0, m.times(v + known(256), u2) + u1, 65535))
    m.learn(equal((t - known(1)) * 256 + q, m.times(v + known(256), u2) + u1))
    found, rest = m.number((low, high)), u - m.times(t, h)
    m.bring(w)
    demand(m.constant(rest - found, 65536) == 0)
    m.show((0, rest + h, MANY), (-131071, rest - found, 65535))
    demand(m.constant(t - digit, 256) == 0)
    m.show((0, t - digit, 511))
    negative = m.copy()
    if negative.possible([equal(rest, found - known(65536))]):
        negative.show((0, m.registers[high] - q, MANY))
    both = [rest - w, rest - q * 256]
    demand(not m.copy().possible([(0, form, MANY) for form in both] +
                          [(0, m.times(both[0], w), None), (0, m.times(both[1], h), None)]))


def begin_compared(m, over, which, h, u2, u1, u0):
    """u and t, for M in the registers `u1` and `u0`; the last estimate of 8 bits that exceeds them is 256."""
    if over:
        m.zero(DIGIT)
    else:
        m.hold(1, m.registers[DIGIT])
    t, found = m.registers[DIGIT] + known(over), m.number((u0, u1))
    less = m.registers[u1] - m.registers[QUOTIENT]
    if which == "negative":
        found = found - known(65536)
        m.hold(0, found + h, MANY)
        m.hold(0, less)
    elif which == "fits":
        m.hold(None, found + h, 65535)
    else:
        m.hold(None, less, -1)
    u = m.times(t, h) + found
    m.hold(0, u - m.registers[u2] * 65536, 65535)
    m.hold(0, h * 256 + known(255) - u)
    return u
