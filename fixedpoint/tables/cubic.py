# SPDX-License-Identifier: MIT
"""Tables for piecewise cubics on 256 intervals, one table per function. The cores of avr/cubic_32.S,
for 32-bit numbers, and of avr/cubic_64.S evaluate

    value + t (slope - t (bend + t twist)),   where t in [0, 1) is the position in the interval,

with value and slope in units of 2^-39, the twist in units of 2^-31, and the bend in units of 2^-31 for
32 bits and of 2^-39 for 64. The function must be increasing and concave, with its first three
derivatives at most 2, 4 and 6.

avr/reciprocal_sqrt_32.S has a core of its own, for a falling function on wider intervals: the value and
the twist, which is in units of 2^-30, are written with the opposite sign."""

from collections import namedtuple
from fractions import Fraction

import page
import table_header

INTERVALS = 256
# Chebyshev nodes on [0, 1], by their number; doubles are accurate enough.
NODES = {2: [0.14644660940672627, 0.8535533905932737],
         3: [0.0669872981077807, 0.5, 0.9330127018922193],
         4: [0.03806023374435663, 0.30865828381745514, 0.6913417161825449, 0.9619397662556434]}
GRID = 1 << 10
CHECKED = 32


def divided_differences(points, values):
    values = list(values)
    for order in range(1, len(points)):
        for i in range(len(points) - 1, order - 1, -1):
            values[i] = (values[i] - values[i - 1]) / (points[i] - points[i - order])
    return values


def nearest(x):
    return (2 * x.numerator + x.denominator) // (2 * x.denominator)


def evaluate_bent(value, slope, bent, t):
    """What follows the twist in cubic_40 and the core of the reciprocal root."""
    t0, t1, t2 = t & 255, t >> 8 & 255, t >> 16
    fall = ((bent >> 16) * t2 << 8) + (bent >> 16) * t1 + (bent >> 8 & 255) * t2 + (
        (bent >> 16) * t0 >> 8) + ((bent >> 8 & 255) * t1 >> 8) + ((bent & 255) * t2 >> 8)
    rest = slope - fall
    s0, s1, s2, s3 = (rest >> 8 * i & 255 for i in range(4))
    return (value + (s3 * t2 << 16) + (s3 * t1 + s2 * t2 << 8) + s3 * t0 + s2 * t1 + s1 * t2 +
            (s2 * t0 >> 8) + (s1 * t1 >> 8) + (s0 * t2 >> 8))


def evaluate_32(row, t):
    """cubic_40 of portable/cubic_32.hpp; t is in units of 2^-24."""
    value, slope, bend, twist = row
    return evaluate_bent(value, slope, (bend << 8) + twist * (t >> 16), t)


def evaluate_falling(row, t):
    """The negative of the mantissa of portable/reciprocal_sqrt_32.hpp; t is in units of 2^-24."""
    value, slope, bend, twist = row
    twisted = -twist * (t >> 16) + (-twist * (t >> 8 & 255) >> 8)
    return evaluate_bent(value, slope, (bend << 8) - 2 * twisted, t)


def evaluate_64(row, t):
    """cubic_64 of portable/cubic_64.hpp; t is in units of 2^-32."""
    value, slope, bend, twist = row
    t0, t1, t2, t3 = (t >> 8 * i & 255 for i in range(4))
    bent = bend + twist * t3 + (twist * t2 >> 8)
    assert 0 <= bent < 1 << 24
    b0, b1, b2 = (bent >> 8 * i & 255 for i in range(3))
    rest = slope - ((b2 * t3 << 8) + b2 * t2 + b1 * t3 + (b2 * t1 >> 8) + (b1 * t2 >> 8) + (b0 * t3 >> 8))
    s0, s1, s2, s3 = (rest >> 8 * i & 255 for i in range(4))
    return (value + (s3 * t3 << 16) + (s3 * t2 + s2 * t3 << 8) + s3 * t1 + s2 * t2 + s1 * t3 +
            (s3 * t0 >> 8) + (s2 * t1 >> 8) + (s1 * t2 >> 8) + (s0 * t3 >> 8))


# The differences between the cores: the bits of t and how many of them multiply the twist, the units
# of twist and bend in units of 2^-39, the bend's bytes, the range of twists and how many adjacent ones
# are tried, the rounding offset in the values, half an ulp of Q32.32, the sign with which values and
# twists are written, and the evaluation.
Core = namedtuple("Core", "t_bits twist_bits twist_unit bend_unit bend_bytes range twists half_ulp sign evaluate")
CORE_32 = Core(24, 8, 256, 256, 2, range(-128, 128), 1, 0, 1, evaluate_32)
FALLING_CORE_32 = Core(24, 16, 512, 256, 2, range(-255, 1), 1, 0, -1, evaluate_falling)
CORE_64 = Core(32, 16, 256, 1, 3, range(-128, 128), 3, 1 << 6, 1, evaluate_64)


def interval(function, i, core):
    """The record and the largest error at the checked points. Each coefficient is rounded before those
    of lower order are fitted, which compensate for most of the rounding."""

    def exact(t):
        position = Fraction(i * GRID + int(t * GRID), INTERVALS * GRID)
        return function(position.numerator, position.denominator)

    points = {n: [Fraction(int(t * GRID), GRID) for t in nodes] for n, nodes in NODES.items()}
    # The kernels use only the upper bits of t for the twist, on average half a unit less.
    cut = Fraction(1, 2 << core.twist_bits)
    twist_unit, unit = core.twist_unit, core.bend_unit

    def record(twist):
        second = divided_differences(
            points[3], [exact(t) + twist_unit * twist * t * t * (t - cut) for t in points[3]])[-1]
        bend = nearest(-second / unit)
        slope = nearest(divided_differences(
            points[2],
            [exact(t) + t * t * (unit * bend + twist_unit * twist * (t - cut)) for t in points[2]])[-1])
        if bend < 0:
            return None  # the cores treat it as unsigned
        assert twist in core.range and 0 <= slope < 1 << 32
        assert bend < (1 << 8 * core.bend_bytes) - 128
        checked = [Fraction(k, GRID) for k in range(0, GRID, GRID // CHECKED - 1)]
        errors = [exact(t) - core.evaluate((0, slope, bend, twist), int(t * (1 << core.t_bits)))
                  for t in checked]
        value = nearest((max(errors) + min(errors)) / 2)
        error = max(max(errors) - value, value - min(errors))
        return error, (value + core.half_ulp, slope, bend, twist)

    third = divided_differences(points[4], [exact(t) for t in points[4]])[-1]
    first = nearest(-third / twist_unit) - core.twists // 2
    error, row = min(filter(None, (record(first + k) for k in range(core.twists))))
    return row, error


def write(name, generator, sentence, structure, function, pages=(),
          intervals=INTERVALS, core=CORE_32):
    """Writes avr/<name>.S and portable/<name>.hpp. `function` takes a numerator and a denominator, for
    ratios from 0 to 1, and returns a Fraction in units of 2^-39. `pages` follow only in the assembly table."""
    found = [interval(function, i, core) for i in range(intervals)]
    rows = [(core.sign * value, slope, bend, core.sign * twist) for (value, slope, bend, twist), _ in found]
    if core is CORE_64:
        error = float(max(error for _, error in found))
        sentence += f"\nThe error is at most {error:.1f} 2^-39 at 34 points per interval; the values include half an ulp of Q32.32."
    records = []
    for value, slope, bend, twist in rows:
        records += [twist & 255, *(bend >> 8 * i & 255 for i in range(core.bend_bytes)),
                    *(slope >> 8 * i & 255 for i in range(4)),
                    *(value >> 8 * i & 255 for i in range(5))]
    page.write_assembly(name, generator, sentence, [
        (f"for each interval: twist, {core.bend_bytes} bytes of bend, 4 of slope, 5 of value",
         records), *pages], 1 if core is CORE_64 else None)
    table_header.write(name, generator, sentence, structure, [
        ("uint32_t", "value", [value >> 8 & 0xffffffff for value, _, _, _ in rows], "0x{:08x}"),
        ("uint8_t", "value_low", [value & 255 for value, _, _, _ in rows], "0x{:02x}"),
        ("uint32_t", "slope", [slope for _, slope, _, _ in rows], "0x{:08x}"),
        ("uint32_t" if core is CORE_64 else "uint16_t", "bend", [bend for _, _, bend, _ in rows],
         f"0x{{:0{2 * core.bend_bytes}x}}"),
        ("uint8_t", "twist", [twist & 255 for _, _, _, twist in rows], "0x{:02x}")])
