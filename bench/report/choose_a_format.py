# SPDX-License-Identifier: GPL-3.0-or-later
"""From the two numbers that a user knows, the largest value and the smallest step, to a type of the
library, its limits and its cost."""
import math
import re

import bounds
import catalogue
import operations
from data import DataError


def integer_bits(largest):
    """The smallest I for which the range -2^(I-1) .. 2^(I-1), without the upper end, contains +-largest."""
    bits = 1
    while not largest < 2.0**(bits - 1):
        bits += 1
    return bits


def fraction_bits(step):
    """The smallest F with 2^-F <= step."""
    bits = 0
    while 2.0**-bits > step:
        bits += 1
    return bits


class Format:
    """I.F bits, as the library names the type."""

    def __init__(self, integer, fraction):
        self.integer, self.fraction = integer, fraction

    @property
    def width(self):
        return self.integer + self.fraction

    @property
    def name(self):
        return catalogue.TYPES.get((self.integer, self.fraction), f"Fixed<{self.integer}, {self.fraction}>")

    @property
    def measured(self):
        """Its name among the measured formats, or None."""
        name = f"q{self.integer}_{self.fraction}"
        return name if name in MEASURED else None

    @property
    def square_overflows_from(self):
        return math.sqrt(2.0**(self.integer - 1))

    @property
    def square_vanishes_below(self):
        """The magnitude whose square is half an ulp."""
        return math.sqrt(2.0**-(self.fraction + 1))

    def stands_still_below(self, rate):
        """The speed, in units per second, whose step at that rate is half an ulp."""
        return rate * 2.0**-(self.fraction + 1)


# The formats in which all operations are measured, by their names in the data.
MEASURED = {name: Format(*map(int, re.findall("[0-9]+", name))) for name in catalogue.FORMATS}
# Those, and what they are compared with.
COMPARED = (*MEASURED, "float")
WIDTHS = sorted({each.width for each in MEASURED.values()})
# The types that have a name in the library.
NAMED = [Format(*bits) for bits in catalogue.TYPES]


def names():
    """The names of types in the library, in Markdown."""
    return [f"`{each.name}`" for each in NAMED]


def choose(largest, step):
    """The narrowest format with that range and that resolution, with a name in the library if one suffices. Bits that
    are left over make the steps finer."""
    integer, fraction = integer_bits(largest), fraction_bits(step)
    for width in WIDTHS:
        if integer + fraction <= width:
            named = [each for each in NAMED
                     if each.width == width and integer <= each.integer and fraction <= each.fraction]
            return max(named, key=lambda each: each.fraction, default=Format(integer, width - integer))
    raise DataError(f"no format has {integer} integer bits and {fraction} fraction bits")


# The example of the lever's arm: the largest value and the smallest step.
ARM = (100, 0.00005)


def why_the_firmware_differs(data):
    """Why the arm of the lever in the firmware has a wider type than it needs alone, in sentences."""
    arm, flashed = choose(*ARM), Format(*catalogue.FLASHED)
    grams = max(row["device_g"] for row in data.some("calibration"))
    if arm.name == flashed.name or choose(grams, ARM[1]).name != flashed.name:
        raise DataError(f"calibration.csv: up to {grams} g do not explain why the firmware uses {flashed.name}, not {arm.name}")
    return (f"The firmware's lever has this arm in `{flashed.name}`, not in `{arm.name}`, because its one number type also holds the "
            f"weights on the force sensors. On the chip they reach {grams:.0f} g, which takes {integer_bits(grams)} integer bits and, with "
            f"the {fraction_bits(ARM[1])} fraction bits of the arm, more than {arm.width} bits.")


def kind(number_format, implementation=operations.OURS):
    return operations.FLOAT if number_format == "float" else (number_format, implementation)


def cost(data, operation, number_format, implementation=operations.OURS):
    """Mean and largest cycles."""
    mean = operations.mean(data, operation, *kind(number_format, implementation))
    if mean is None:
        return "–"
    return f"{mean:.0f} ({bounds.known(data, operation, *kind(number_format, implementation))['cycles_max']})"


def flash(data, operation, number_format):
    """Bytes, with everything that the operation pulls in."""
    row = operations.row(data, operation, *kind(number_format))
    return row["flash_bytes"] if row else "–"
