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
    def below(slope):
        return all(root + (slope * l >> 8) <= exact_root(h, l) for l in range(256))

    slope = 128 if h == 255 else max(slope for slope in range(256) if below(slope))
    shortfall = max(exact_root(h, l) - root - (slope * l >> 8) for l in range(256))
    assert shortfall <= 2, (h, shortfall)
    return slope


def check_extrapolation(root, slope):
    """The 24-bit root S = 256 c + floor(floor(e / 256) slope / 256), with c the 16-bit root and
    e = m - c^2, is less than 5 off sqrt(m 2^16) at both ends of the 2^16 numbers m that share a c.
    Between the ends S - sqrt(m 2^16) is convex but for the rounding down, which stays below 2."""
    for t in range(256 * FIRST, 1 << 16):
        h, l = divmod(t, 256)
        c = root[h] + (slope[h] * l >> 8)
        for m in (t << 16, (t << 16) + 0xFFFF):
            s = 256 * c + ((m - c * c >> 8) * slope[h] >> 8)
            assert (max(s - 5, 0)) ** 2 <= m << 16 < (s + 5) ** 2, (h, l)


def page(comment, values):
    rows = [f"    // {comment}"]
    for start in range(0, len(values), 16):
        rows.append("    .byte " + ", ".join(f"{v:3d}" for v in values[start : start + 16]))
    return rows


def main():
    root = [nearest_root(h << 16) if h < FIRST else exact_root(h, 0) for h in range(256)]
    slope = [0] * FIRST + [largest_slope(h, root[h]) for h in range(FIRST, 256)]
    check_extrapolation(root, slope)
    lines = [
        "// SPDX-License-Identifier: MIT",
        "// DO NOT EDIT: written by fixedpoint/tables/sqrt.py, which says what the entries are.",
        "#ifdef __AVR__",
        "    .section .progmem.data.fixedpoint_sqrt_table, \"a\", @progbits",
        "    .balign 256",
        "    .global fixedpoint_sqrt_table",
        "    .type fixedpoint_sqrt_table, @object",
        "fixedpoint_sqrt_table:",
        *page("root, low bytes", [r & 255 for r in root]),
        *page("root, high bytes", [r >> 8 for r in root]),
        *page("slope", slope),
        "    .size fixedpoint_sqrt_table, . - fixedpoint_sqrt_table",
        "#endif",
    ]
    OUTPUT.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
