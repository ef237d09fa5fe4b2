# SPDX-License-Identifier: GPL-3.0-or-later
"""Other libraries compared with ours."""
import style
from data import DataError

# The names on the pages of the variants of rivals.csv, in the order of the table's columns.
NAMES = {
    "libfixmath": "libfixmath",
    "libfixmath_bytes": "libfixmath, 8-bit option",
    "fixed_points": "FixedPointsArduino",
    "fix_math": "FixMath (Mozzi)",
    "avrfix": "AVRfix",
    "fixedptc": "fixedptc",
    "fixedptc_default": "fixedptc, its own split",
    "gcc_accum": "GCC _Accum, s16.15",
    "fxlib": "avr-libc fxlib, s16.15",
    "wide_integer": "64-bit integers",
    "fp_double": "fp64lib, 64-bit float",
}
MARKERS = dict(zip(NAMES, "xx+1233|4_*"))
COLOURS = dict(zip(NAMES, ("#555555", "#999999", *["#777777"] * 9)))
# Errors closer than this count as equal: they come from one class of operands, not from the same operands.
SAME = 0.95
# Which of our formats a format is compared with: one with as many bits.
OURS = {"q16_16": "q16_16", "s16_15": "q16_16", "float64": "q32_32"}


def judged(data, **wanted):
    """Those that return for all operands; empty if nothing was measured."""
    found = data.rows("rivals", **wanted) if data.has("rivals") else []
    unknown = {row["variant"] for row in found} - set(NAMES)
    if unknown:
        raise DataError(f"rivals.csv has a variant that the pages have no name for: {min(unknown)}")
    return [row for row in found if row["regular"] and not row["failure"]]


def comparable(data):
    """Those that the explorer shows next to ours, which already include the compiler's own types."""
    return [row for row in judged(data) if row["variant"] != "gcc_accum"]


def rows(data, operation=None, against=("q16_16", "q32_32")):
    """Those that are compared with these formats of ours, on operands of 0.01 to 20."""
    return [row for row in judged(data, operands="physics")
            if OURS.get(row["format"]) in against and operation in (None, row["operation"])]


def label(number_format, variant):
    """The name of a library's numbers, e.g. libfixmath, Q16.16."""
    if number_format == "float64":
        return NAMES[variant]
    return f"{NAMES[variant].split(', s16')[0]}, {style.format_label(number_format)}"


def ours(data, row):
    """Our function that a rival's is compared with, or None."""
    return next(iter(data.rows("operations", operation=row["operation"], format=OURS[row["format"]],
                               implementation="default", operands="physics")), None)


def origins(data):
    """Which libraries were measured, in a sentence: name, version, commit and date."""
    by_date = {}
    for name, row in {row["rival"]: row for row in rows(data)}.items():
        version = [row["version"] and str(row["version"]), row["commit"] and f"at {row['commit']}"]
        by_date.setdefault(row["measured"], []).append(" ".join([name.replace("_", " "), *filter(None, version)]))
    return " ".join(f"Measured on {date}: {'; '.join(names)}." for date, names in by_date.items())


def listed(names):
    """add, divide and log."""
    return ", ".join(names[:-1]) + " and " + names[-1] if len(names) > 1 else names[0]


def finding(data, against):
    """Where another library takes fewer cycles than ours of that format, or as many, and how often its error or its
    flash is smaller; empty if none is compared with that format."""
    ahead, equal, count, smaller, exacter = {}, set(), 0, 0, 0
    for row in rows(data, against=(against,)):
        mine = ours(data, row)
        if mine is None:
            continue
        count += 1
        smaller += row["flash_bytes"] < mine["flash_bytes"]
        same_range = mine["regular"] == mine["samples"]  # else ours has no results as large as the other's
        exacter += same_range and row["rms_error"] < SAME * mine["rms_error"]
        if row["cycles_mean"] < mine["cycles_mean"]:
            ahead.setdefault(NAMES[row["variant"]], []).append(row["operation"])
        elif row["cycles_mean"] == mine["cycles_mean"]:
            equal.add(row["operation"])
    if not count:
        return ""
    text = f"Of {count} functions of other libraries, compared with {style.format_label(against)}, "
    if ahead:
        faster = sum(map(len, ahead.values()))
        text += (f"{faster} {'take' if faster > 1 else 'takes'} fewer cycles than ours: "
                 + "; ".join(f"{listed(operations)} of {name}" for name, operations in ahead.items()))
    else:
        text += "none takes fewer cycles than ours"
    if equal:
        text += f"; some take as many for {listed(sorted(equal))}"
    return (f"{text}. {exacter} {'has' if exacter == 1 else 'have'} a smaller error than ours, {smaller} "
            f"{'takes' if smaller == 1 else 'take'} less flash.")
