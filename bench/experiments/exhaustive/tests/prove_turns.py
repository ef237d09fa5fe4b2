#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Proves the largest errors of the angles of vectors in turns and degrees for all pairs of operands: z3 examines the
machine code of the device programs, with every register a vector of bits.

usage: prove_turns.py FOLDER    the folder of the device programs

fixedpoint/prove_angles_32 proves the angle a, in units of 2^-28, of the unchanged operands. fixedpoint/prove_products
proves its product with a constant c, a c / 2^32 rounded to nearest. Proven here: these kernels are called correctly, and
the result is the product rounded to nearest and saturated to the format, which increases no error. In units of the
product, its error is

    1/2, plus c / 2^32 times the error of a, plus pi 2^28 times the error of c / 2^32, by which it misses half a turn.

Then instructions are left out in turn, and each time the proof must fail; it may succeed without a sixth of them, which
the compiler emits although they change nothing."""
import sys
from functools import partial
from pathlib import Path

import z3
from mpmath import mp, mpf

from prove_sums import Calling, saturated, places
from machine_code import Program, demand
from prove_angles_32 import BOUND

# For each function: the fraction bits of the product, half a turn, and the bound in ulp for each number of fraction bits.
UNITS = {"turns": (29, mpf(1) / 2, {8: 0.500001, 16: 0.5001}), "degrees": (21, mpf(180), {8: 0.5002, 16: 0.527})}
ANGLE, PRODUCT = "fixedpoint_atan2_q4_28", "fixedpoint_multiply_q0_32"
LARGEST = 1 << 29  # of the product, and beyond: (pi 2^28 + 1) c / 2^32 + 1/2
FORMATS = {"q8_8": (16, 8), "q16_16": (32, 16)}
EVERY = 2


def angle(width, dropped, constant, machine):
    y, x = (z3.SignExt(32 - width, machine.number(low, width // 8)) for low in places(width, 2))

    def check(machine, _):
        (coordinates, radians), (factors, product) = machine.all_calls()
        result = machine.number(places(width, 1)[0], width // 8)
        wanted = saturated((z3.SignExt(2, product) + (1 << dropped - 1)) >> dropped, width)
        machine.holds += [product >= -LARGEST, product <= LARGEST]
        demand(machine.impossible(z3.Not(z3.And(coordinates[0] == y, coordinates[1] == x, factors[0] == radians,
                                                factors[1] == constant, result == z3.Extract(width - 1, 0, wanted)))))
    return check


def main():
    mp.prec = 100
    failed = False
    for number_format, (width, fraction) in FORMATS.items():
        for unit, (bits, half_turn, bounds) in UNITS.items():
            exact = half_turn / mp.pi * 2**(bits - 28)
            constant, dropped = int(mp.nint(exact * 2**32)), bits - fraction
            part = mpf(constant) / 2**32
            demand((mp.pi * 2**28 + 1) * part + 1 < LARGEST)
            found = mpf(1) / 2 + (mpf(1) / 2 + part * BOUND + mp.pi * 2**28 * abs(part - exact)) / 2**dropped
            name = f"atan2_{unit}_{number_format}_default"
            stretch = name, partial(angle, width, dropped, constant), (None,), (), ((),), (None,)
            program = Program([stretch], partial(Calling, [(ANGLE, 2, 32), (PRODUCT, 2, 32)]),
                              elf=Path(sys.argv[1]) / f"{number_format}_auxiliary.elf")
            visited = program.prove(*stretch)
            needless = program.survivors(stretch, visited, EVERY, ("ret",))
            print(f"{name}: errs by less than {mp.nstr(found, 10)} ulp; of {len(visited)} instructions one in {EVERY} was "
                  f"left out, without effect {needless}")
            failed |= found >= bounds[fraction] or 6 * EVERY * len(needless) > len(visited)
    return failed


if __name__ == "__main__":
    sys.exit(main())
