#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/leading_one_table.S: where a byte has its leading one."""

import page

if __name__ == "__main__":
    logarithms = [max(0, (2 * i).bit_length() - 1) for i in range(128)]
    page.write_assembly("leading_one_table", "leading_one.py",
                        "Of a byte that is not zero, by its upper 7 bits.", [
                            ("The base-2 logarithm, rounded downward", logarithms),
                            ("The factor that brings the leading one to the top",
                             [128 >> logarithm for logarithm in logarithms])])
