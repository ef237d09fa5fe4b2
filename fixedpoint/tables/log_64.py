#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/log_64_table.S and portable/log_64_table.hpp: the natural
logarithm on [1, 2] and the multiples of ln 2, for Q32.32."""

import cubic
from exponential_series import logarithm
from log_32 import scaled

LN2 = logarithm(2, 1, 55)

if __name__ == "__main__":
    records = []
    # The leading one of a number of Q32.32 is in 2^-32..2^30.
    for exponent in range(-32, 31):
        multiple = exponent * LN2 + (1 << 15) >> 16
        records += [multiple >> 8 * i & 255 for i in range(6)]
    cubic.write("log_64_table", "log_64.py",
                "ln(1 + x) on 256 intervals of [0, 1], cubics in the layout of tables/cubic.py.",
                "Log64Table", scaled, [
                    ("e ln 2 in units of 2^-39, from e = -32 on", records)],
                core=cubic.CORE_64)
