#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes src/fixedpoint/avr/divide_q4_4_table.S: the reciprocal of every Q4.4 divisor as a signed
16-bit number, at the scale that divide_q4_4.S states."""

import page


def reciprocal(index):
    divisor = index - 256 if index >= 128 else index
    if abs(divisor) < 2:
        return 0
    scale = 2**16 if abs(divisor) <= 16 else 2**19
    return min((2 * scale + divisor) // (2 * divisor), 2**15 - 1)


if __name__ == "__main__":
    reciprocals = [reciprocal(index) for index in range(256)]
    page.write_assembly("divide_q4_4_table", "divide_q4_4.py", "Signed reciprocals of Q4.4 divisors.",
                        [("low bytes", [r & 255 for r in reciprocals]),
                         ("high bytes", [r >> 8 & 255 for r in reciprocals])])
