#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes the tables of the reciprocal square root: src/fixedpoint/avr/reciprocal_sqrt_table.S for
the kernels and src/fixedpoint/portable/reciprocal_sqrt_table.hpp for the portable implementation.

The mantissa of the root is y(t) = 2^22 / sqrt(t / 2^16), 2^14 <= t < 2^16. With t = 256 h + l + x / 256
it is the chord over [256 h, 256 h + 256] minus a parabola:

    value[h] - floor(l slope_low / 256) - l slope_high - floor(x slope_high / 256)
             - floor(floor(l (256 - l) / 128) bulge / 128)

value[h] h = 64..255: as above; h = 2..63: the nearest integer to 2^24 / sqrt(h), the Q16.16 result
         of the raw number h; h = 1, 0: the lower 24 bits of 2^24 and of the largest number.
slope[h], bulge[h] h = 64..255: as above.

Of the integers near the exact chord and parabola, those that minimise the largest error of the
Q16.16 result are chosen. The mantissa is shifted right by 2 bits if l = x = 0 (raw numbers of up to
8 bits), by 3, 4, 5 and 6 if x = 0 and l is a multiple of 64, 16, 4 and 1, and by 7 or more
otherwise.
"""
import math
import pathlib

import table_header

SOURCE = pathlib.Path(__file__).parent.parent / "src/fixedpoint"
FIRST = 64
GUARD = 24  # fraction bits of the exact values
MULTIPLES = ((256, 2), (64, 3), (16, 4), (4, 5), (1, 6))
SAMPLES = [(l, x, 7) for l in range(0, 256, 5) for x in (64, 192, 255)] + [
    (l, 0, next(shift for multiple, shift in MULTIPLES if l % multiple == 0)) for l in range(256)
]


def mantissa(t, x=0):
    """y in units of 2^-GUARD, at t + x / 256."""
    return math.isqrt((1 << 2 * (22 + GUARD) + 24) // (256 * t + x))


def rounded(scaled):
    return scaled + (1 << GUARD - 1) >> GUARD


def fall(slope, bulge, l, x):
    parabola = (l * (256 - l) >> 7) * bulge >> 7
    return (l * (slope & 255) >> 8) + l * (slope >> 8) + (x * (slope >> 8) >> 8) + parabola


def entry(h):
    exact = [(l, x, shift, mantissa(256 * h + l, x)) for l, x, shift in SAMPLES]
    start, middle, end = (mantissa(256 * h + l) for l in (0, 128, 256))
    best = None
    for slope in range(rounded(start - end) - 2, rounded(start - end) + 3):
        for bulge in range(rounded((start + end) // 2 - middle) - 2, 256):
            if bulge > rounded((start + end) // 2 - middle) + 3:
                break
            # The value that would be exact, for each operand. The best value is closest to all of
            # them; for each shift, only the smallest and the largest matter.
            limits = {}
            for l, x, shift, y in exact:
                limits.setdefault(shift, []).append(y + (fall(slope, bulge, l, x) << GUARD))
            ends = [(shift, min(of_it), max(of_it)) for shift, of_it in limits.items()]
            for value in range(rounded(start) - 2, rounded(start) + 3):
                value = min(value, (1 << 23) - 1)
                error = max(max((value << GUARD) - low, high - (value << GUARD)) >> shift
                            for shift, low, high in ends)
                if best is None or error < best[0]:
                    best = (error, value, slope, bulge)
    return best


def direct(raw):
    if raw < 2:
        return (1 << 24) - 1 if raw == 0 else 0
    return math.isqrt((1 << 50) // raw) + 1 >> 1


def page(comment, values):
    rows = [f"    // {comment}"]
    for start in range(0, len(values), 16):
        rows.append("    .byte " + ", ".join(f"{v:3d}" for v in values[start : start + 16]))
    return rows


def main():
    entries = [entry(h) for h in range(FIRST, 256)]
    value = [direct(raw) for raw in range(FIRST)] + [e[1] for e in entries]
    slope = [e[2] for e in entries]
    bulge = [e[3] for e in entries]
    unused = [0] * FIRST
    notice = "DO NOT EDIT: written by fixedpoint/tables/reciprocal_sqrt.py, which describes the entries."
    (SOURCE / "avr/reciprocal_sqrt_table.S").write_text(
        "\n".join(
            [
                "// SPDX-License-Identifier: MIT",
                f"// {notice}",
                "#ifdef __AVR_HAVE_MUL__",
                '#include "prelude.inc"',
                "    TABLE fixedpoint_reciprocal_sqrt_table",
                *page("slope, low bytes", unused + [s & 255 for s in slope]),
                *page("slope, high bytes", unused + [s >> 8 for s in slope]),
                *page("bulge", unused + bulge),
                *page("value, low bytes", [v & 255 for v in value]),
                *page("value, middle bytes", [v >> 8 & 255 for v in value]),
                *page("value, high bytes", [v >> 16 for v in value]),
                "    ENDTABLE fixedpoint_reciprocal_sqrt_table",
                "#endif",
            ]
        )
        + "\n"
    )
    table_header.write(
        "reciprocal_sqrt_table", "reciprocal_sqrt.py, which describes the entries.",
        "From 2^14 on, in steps of 256.", "ReciprocalSqrtTable",
        [("uint32_t", "value", value[FIRST:], "{}"), ("uint16_t", "slope", slope, "{}"),
         ("uint8_t", "bulge", bulge, "{}")])


if __name__ == "__main__":
    main()
