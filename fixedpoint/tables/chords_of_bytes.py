# SPDX-License-Identifier: MIT
"""Linear interpolation for the 16-bit kernels: on an interval of 256 positions f = 0..255 a function
is value + (slope f >> 8). The slope has 8 bits; the value is in units of 2^-5 ulp and includes half
an ulp. The value is stored as whole ulps and remaining units: two bytes, so that the product is
added to the second one without a carry."""

import page
import table_header

UNITS_PER_ULP = 32


def chord(targets):
    """(value, slope) that minimise the maximum of |value + (slope f >> 8) - targets[f]|."""
    steepness = round((targets[255] - targets[0]) * 256 / 255)
    best = None
    for slope in range(max(steepness - 3, 0), min(steepness + 4, 256)):
        rests = [target - (slope * f >> 8) for f, target in enumerate(targets)]
        value = round((max(rests) + min(rests)) / 2)
        error = max(max(rests) - value, value - min(rests))
        if best is None or error < best[0]:
            best = (error, value, slope)
    return best[1:]


def of(function, intervals):
    """The chords of function(interval, position) in ulp."""
    return [chord([UNITS_PER_ULP * function(i, f) + UNITS_PER_ULP // 2 for f in range(256)])
            for i in range(intervals)]


def write(name, generator, sentence, structure, chords):
    """Writes avr/<name>.S, in which the bytes of an interval are as far apart as there are
    intervals, and portable/<name>.hpp with the same numbers."""
    # The last value may be 256 ulp, which does not fit in a byte: the units have room for more.
    wholes = [min(value // UNITS_PER_ULP, 255) for value, _ in chords]
    units = [value - UNITS_PER_ULP * whole for (value, _), whole in zip(chords, wholes)]
    slopes = [slope for _, slope in chords]
    assert all(unit + slope < 256 for unit, slope in zip(units, slopes))
    page.write_assembly(name, generator, sentence,
                        [("slope", slopes), ("units of 2^-5 ulp", units), ("whole ulps", wholes)])
    table_header.write(name, generator, sentence, structure,
                       [("uint16_t", "value", [value for value, _ in chords], "{:4d}"),
                        ("uint8_t", "slope", slopes, "{:3d}")])
