# SPDX-License-Identifier: MIT
"""Linear interpolation for the 16-bit kernels: on an interval of 256 positions f = 0..255 a function
is value + (slope f >> 8). The slope has 8 bits; the value is in units of 2^-5 ulp, unless a table
has others, and includes half an ulp. It is stored as whole ulps and remaining units: two bytes, so
that the product is added to the second one without a carry."""

import page
import table_header

UNIT_BITS = 5
UNITS_PER_ULP = 2**UNIT_BITS


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


def write(name, generator, sentence, structure, chords, unit_bits=UNIT_BITS, stride=1):
    """Writes avr/<name>.S and portable/<name>.hpp with the same numbers. With a stride of 1, the
    bytes of an interval are as far apart as there are intervals, otherwise next to each other."""
    # The last value may be 256 ulp, which does not fit in a byte: the units have room for more.
    wholes = [min(value >> unit_bits, 255) for value, _ in chords]
    units = [value - (whole << unit_bits) for (value, _), whole in zip(chords, wholes)]
    slopes = [slope for _, slope in chords]
    assert all(unit + slope < 256 for unit, slope in zip(units, slopes))
    parts = [("slope", slopes), (f"units of 2^-{unit_bits} ulp", units), ("whole ulps", wholes)]
    if stride > 1:
        unused = [[0] * len(chords)] * (stride - len(parts))
        entries = zip(*(numbers for _, numbers in parts), *unused)
        parts = [(", ".join([title for title, _ in parts] + ["unused"] * len(unused)),
                  [byte for entry in entries for byte in entry])]
    page.write_assembly(name, generator, sentence, parts)
    table_header.write(name, generator, sentence, structure,
                       [("uint16_t", "value", [value for value, _ in chords], "{:4d}"),
                        ("uint8_t", "slope", slopes, "{:3d}")])
