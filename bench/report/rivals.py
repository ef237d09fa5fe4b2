# SPDX-License-Identifier: GPL-3.0-or-later
"""Other libraries beside ours."""
import style
from data import DataError

# How the pages call the variants of rivals.csv, in the order of the table's columns.
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
}
MARKERS = dict(zip(NAMES, "xx+1233|4_"))
COLOURS = dict(zip(NAMES, ("#555555", "#999999", *["#777777"] * 8)))
# Of 32 bits that hold the same range to within a bit.
FORMATS = {"q16_16": 16, "s16_15": 15}


def judged(data, **wanted):
    """Those that return for all operands; none where nothing was measured."""
    found = data.rows("rivals", **wanted) if data.has("rivals") else []
    unknown = {row["variant"] for row in found} - set(NAMES)
    if unknown:
        raise DataError(f"rivals.csv has a variant that no page has a name for: {min(unknown)}")
    return [row for row in found if row["regular"] and not row["failure"]]


def comparable(data):
    """Those that the explorer shows beside ours, where the compiler's own types stand already."""
    return [row for row in judged(data) if row["variant"] != "gcc_accum"]


def rows(data, operation=None):
    """Those of the formats that are held against Q16.16, on operands of 0.01 to 20."""
    return [row for row in judged(data, operands="physics")
            if row["format"] in FORMATS and operation in (None, row["operation"])]


def label(number_format, variant):
    """How a library's numbers are called, e.g. libfixmath, Q16.16."""
    return f"{NAMES[variant].split(', s16')[0]}, {style.format_label(number_format)}"


def point(row):
    """Cycles, and the rms error in the unit of the result."""
    return row["cycles_mean"], row["rms_ulp"] * 2.0 ** -FORMATS[row["format"]]


def ours(data, operation):
    """Cycles, rms error in ulp and flash of Q16.16; none where it has no such operation."""
    for row in data.rows("operations", operation=operation, format="q16_16", implementation="default",
                         operands="physics"):
        return row["cycles_mean"], row["rms_error"] * 2 ** FORMATS["q16_16"], row["flash_bytes"]
    return None


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


def finding(data):
    """Where another library takes fewer cycles than ours, or as many, and how often less flash."""
    ahead, equal, count, smaller = {}, set(), 0, 0
    for row in rows(data):
        mine = ours(data, row["operation"])
        if mine is None:
            continue
        count += 1
        smaller += row["flash_bytes"] < mine[2]
        if row["cycles_mean"] < mine[0]:
            ahead.setdefault(NAMES[row["variant"]], []).append(row["operation"])
        elif row["cycles_mean"] == mine[0]:
            equal.add(row["operation"])
    text = f"Of {count} functions of other libraries "
    if ahead:
        faster = sum(map(len, ahead.values()))
        text += (f"{faster} {'take' if faster > 1 else 'takes'} fewer cycles than ours: "
                 + "; ".join(f"{listed(operations)} of {name}" for name, operations in ahead.items()))
    else:
        text += "none takes fewer cycles than ours"
    if equal:
        text += f"; some take as many in {listed(sorted(equal))}"
    return f"{text}. {smaller} take less flash than ours; where flash counts, `Small` has short tables."
