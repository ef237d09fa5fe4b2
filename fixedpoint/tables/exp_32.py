#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/avr/exp_32_table.S and portable/exp_32_table.hpp: the
exponential function of the reduced argument, for every 32-bit format."""

from fractions import Fraction

import cubic
from exponential_series import exponential

GUARD = 24


def risen(numerator, denominator):
    return Fraction((1 << 39 + GUARD) - exponential(-numerator, denominator, 39 + GUARD), 1 << GUARD)


if __name__ == "__main__":
    cubic.write("exp_32_table", "exp_32.py",
                "1 - e^-x on the first 208 of 256 intervals of [0, 1], which reach beyond ln 2, "
                "cubics in\n"
                "the layout of tables/cubic.py.",
                "Exp32Table", risen, intervals=208)
