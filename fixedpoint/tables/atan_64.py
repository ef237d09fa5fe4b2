#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/atan_64_table.S and portable/atan_64_table.hpp: the arc
tangent on [0, 1], for Q32.32."""

import cubic
from atan_32 import scaled

if __name__ == "__main__":
    cubic.write("atan_64_table", "atan_64.py",
                "atan(x) on 256 intervals of [0, 1], cubics in the layout of tables/cubic.py.",
                "Atan64Table", scaled, core=cubic.CORE_64)
