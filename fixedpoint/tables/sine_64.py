#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/sine_64_table.S and portable/sine_64_table.hpp: the sine on
the first quarter turn, for Q32.32."""

import cubic
from sine_32 import sine

if __name__ == "__main__":
    cubic.write("sine_64_table", "sine_64.py",
                "sin(pi/2 x) on 256 intervals of [0, 1], cubics in the layout of tables/cubic.py.",
                "Sine64Table", sine, core=cubic.CORE_64)
