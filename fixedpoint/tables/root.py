#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes src/fixedpoint/avr/root_table.S: floor(sqrt(256 h)) for h = 64..255, which is the integer
root of the 16-bit number h:l, or 1 less."""

from math import isqrt

import page

if __name__ == "__main__":
    page.write_assembly("root_table", "root.py", "floor(sqrt(256 h)), h = 64..255.",
                        [("roots", [isqrt(256 * h) for h in range(64, 256)])])
