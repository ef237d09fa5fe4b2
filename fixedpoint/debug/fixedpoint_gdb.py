# SPDX-License-Identifier: MIT
"""Fixed-point numbers in gdb: `print x` shows 0.3800 (raw 24904).

    (gdb) source fixedpoint/debug/fixedpoint_gdb.py

or the same line in ~/.gdbinit. It shows as many decimals as the format can resolve."""

from fractions import Fraction

import gdb
import gdb.printing


def decimal(value, decimals):
    """The fraction with that many decimals, rounded half up."""
    digits = f"{abs((value * 10**decimals + Fraction(1, 2)).__floor__()):0{decimals + 1}}"
    sign = "-" if value < 0 and int(digits) else ""
    return sign + (f"{digits[:-decimals]}.{digits[-decimals:]}" if decimals else digits)


class FixedPrinter:
    def __init__(self, value):
        self.raw = int(value["raw_"])
        self.fraction_bits = int(value.type.strip_typedefs().template_argument(1))

    def to_string(self):
        value = Fraction(self.raw, 2**self.fraction_bits)
        return f"{decimal(value, self.fraction_bits * 30103 // 100000)} (raw {self.raw})"


printers = gdb.printing.RegexpCollectionPrettyPrinter("fixedpoint")
printers.add_printer("Fixed", "^fixedpoint::Fixed<.*>$", FixedPrinter)
gdb.printing.register_pretty_printer(None, printers, replace=True)
