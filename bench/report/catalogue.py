# SPDX-License-Identifier: GPL-3.0-or-later
"""The catalogue, read from the tables of the bench and from the library: groups of operations, formats of the library
and their names there, and implementations."""
import pathlib
import re

BENCH = pathlib.Path(__file__).resolve().parents[1]
_OPERATIONS = (BENCH.parent / "reference" / "operation_table.h").read_text(encoding="utf-8")
_LIBRARY = (BENCH.parent / "fixedpoint" / "src" / "fixedpoint" / "fixed.hpp").read_text(encoding="utf-8")
_FORMATS = (BENCH / "lab" / "catalogue" / "formats.h").read_text(encoding="utf-8")
_SUBJECTS = (BENCH / "lab" / "catalogue" / "subjects.h").read_text(encoding="utf-8")

# The formats of the library with a sign, in which all operations are measured: "q4_4", ...
FORMATS = tuple(re.findall(r"^#define FORMAT_(q\w+)\(", _FORMATS, re.MULTILINE))
# The types that have a name in the library, by their integer and fraction bits: "Q4_4", ...
TYPES = {(int(integer), int(fraction)): name
         for name, integer, fraction in re.findall(r"^using (Q\w+) = Fixed<(\d+), (\d+)>;$", _LIBRARY, re.MULTILINE)}
# The integer and fraction bits of the lever that is flashed.
_LEVER = (BENCH.parent / "firmware" / "src" / "firmware" / "lever_geometry.hpp").read_text(encoding="utf-8")
FLASHED = tuple(map(int, re.search(r"^using LeverScalar = fixedpoint::Fixed<(\d+), (\d+)[,>]", _LEVER, re.MULTILINE).groups()))
# Provenance, label, and whether its results are the default's, of each implementation.
IMPLEMENTATIONS = {
    name: {"provenance": provenance, "label": label, "as_default": host == "as_default"}
    for name, provenance, host, label in re.findall(r'^ *X\((\w+), \w+, (\w+), (\w+), [^"]*"(.*)"\)$', _SUBJECTS, re.MULTILINE)}


def operations(group):
    """The operations of a group, such as ANGLE_OPERATIONS, in the order of the table."""
    rows = re.search(rf"^#define {group}\(X, \.\.\.\)((?:.*\\\n)*.*)", _OPERATIONS, re.MULTILINE)[1]
    return tuple(name for within, one in re.findall(r"(\w+_OPERATIONS)\(|OPERATION_(\w+)\(", rows)
                 for name in (operations(within) if within else [one]))
