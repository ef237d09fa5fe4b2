#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes src/fixedpoint/avr/sqrt_table.S: square roots of one byte and the slopes between them.

root[h]  h = 0..63: the nearest integer to 256 sqrt(h), the Q16.16 root of the raw number h.
         h = 64..255: floor(4096 sqrt(h)), the 16-bit root of the 16-bit number 256 h.
slope[h] h = 64..255: the largest byte d for which root[h] + floor(d l / 256) does not exceed
         floor(sqrt((256 h + l) 2^16)) for any byte l, except that slope[255] = 128, the slope
         of the root at 2^32: with it a 24-bit root that is extrapolated stays below 2^24.
         The kernels rely on both, and on the two numbers being at most 2 apart.
"""
import math
import pathlib

OUTPUT = pathlib.Path(__file__).parent.parent / "src/fixedpoint/avr/sqrt_table.S"
FIRST = 64


def nearest_root(n):
    root = math.isqrt(n)
    return root + (n > root * root + root)


def exact_root(h, l):
    return math.isqrt((256 * h + l) << 16)


def largest_slope(h, root):
    rises = [exact_root(h, l) - root for l in range(256)]
    # floor(d l / 256) <= rise if d l < 256 (rise + 1).
    slope = 128 if h == 255 else min(255, *((256 * rises[l] + 255) // l for l in range(1, 256)))
    shortfall = max(rise - (slope * l >> 8) for l, rise in enumerate(rises))
    assert shortfall <= 2, (h, shortfall)
    return slope


def check_extrapolation(root, slope):
    """The 24-bit root S = 256 c + floor(floor(e / 256) slope / 256), with c the 16-bit root and
    e = m - c^2, is less than 5 off sqrt(m 2^16) at both ends of the 2^16 numbers m that share a c.
    Between the ends S - sqrt(m 2^16) is convex, apart from the rounding down, which is below 2."""
    for t in range(256 * FIRST, 1 << 16):
        h, l = divmod(t, 256)
        c = root[h] + (slope[h] * l >> 8)
        for m in (t << 16, (t << 16) + 0xFFFF):
            s = 256 * c + ((m - c * c >> 8) * slope[h] >> 8)
            assert (max(s - 5, 0)) ** 2 <= m << 16 < (s + 5) ** 2, (h, l)


def check_third_digit(root, slope):
    """The 32-bit root that length_long.S takes of a 48-bit number M is less than 0.44 off.
    S, 6 less than above, is d too small. Its remainder (S + d)^2 - S^2 times slope / 2^24 is q,
    nearly 2^8 d; with x = floor((slope (S >> 8) - 2^23) / 2^10) it becomes q - floor(q / 32) x /
    256. The dropped parts of the remainder and of q amount to less than 1/64."""
    for t in range(256 * FIRST, 1 << 16):
        h, l = divmod(t, 256)
        c = root[h] + (slope[h] * l >> 8)
        # Without rounding, S - sqrt(M) is convex in M, and smallest where the slopes agree.
        # Rounding subtracts less than 2, and an ignored borrow adds less than 1.
        ends = math.sqrt(t << 16), math.sqrt(t + 1 << 16)
        agree = min(max((1 << 23) / slope[h], ends[0]), ends[1])
        lack = [256 * r + 6 - 256 * c - (r * r - c * c) * slope[h] / 65536 for r in (*ends, agree)]
        extremes = min(lack) - 1, max(lack) + 2
        assert 0 < extremes[0] and extremes[1] < 12, (h, l)
        for upper in range(c - 1, c + 4):
            x = (slope[h] * upper >> 10) - (1 << 13)
            assert -128 <= x < 128, (h, l)
            for s in (256 * upper, 256 * upper + 255):
                for d in extremes:
                    q = (2 * s + d) * d * slope[h] / (1 << 24)
                    for floor in (q / 32 - 1, q / 32):
                        assert abs(q - floor * x / 256 - 256 * d) < 0.44 - 1 / 64, (h, l)


def page(comment, values):
    rows = [f"    // {comment}"]
    for start in range(0, len(values), 16):
        rows.append("    .byte " + ", ".join(f"{v:3d}" for v in values[start : start + 16]))
    return rows


def main():
    root = [nearest_root(h << 16) if h < FIRST else exact_root(h, 0) for h in range(256)]
    slope = [0] * FIRST + [largest_slope(h, root[h]) for h in range(FIRST, 256)]
    check_extrapolation(root, slope)
    check_third_digit(root, slope)
    lines = [
        "// SPDX-License-Identifier: MIT",
        "// DO NOT EDIT: written by fixedpoint/tables/sqrt.py, which describes the entries.",
        "#ifdef __AVR_HAVE_MUL__",
        '#include "prelude.inc"',
        "    TABLE fixedpoint_sqrt_table",
        *page("root, low bytes", [r & 255 for r in root]),
        *page("root, high bytes", [r >> 8 for r in root]),
        *page("slope", slope),
        "    ENDTABLE fixedpoint_sqrt_table",
        "#endif",
    ]
    OUTPUT.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
