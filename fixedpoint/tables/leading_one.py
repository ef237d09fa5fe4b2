#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/leading_one_table.S: the position of the leading one in a
byte."""

import page

if __name__ == "__main__":
    logarithms = [max(0, (2 * i).bit_length() - 1) for i in range(128)]
    page.write_assembly("leading_one_table", "leading_one.py",
                        "For a byte that is not zero, indexed by its upper 7 bits.", [
                            ("The base-2 logarithm, rounded downward", logarithms),
                            ("The factor that moves the leading one to the top",
                             [128 >> logarithm for logarithm in logarithms])])
