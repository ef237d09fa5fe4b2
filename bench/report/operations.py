# SPDX-License-Identifier: GPL-3.0-or-later
"""The cost and the error of an operation, over operands of the class `physics`."""
import math

import bounds
import catalogue
import style

OURS = bounds.OURS
FLOAT = ("float", "libc")
PUBLISHED = ("q16_16", "published")
BASIC = ("add", "multiply", "divide", "sqrt", "sin", "atan2")
# Functions that most formats make from the cores of others: fixedpoint/portable/elementary_functions.hpp. They are reported
# separately, since a mean over both kinds would describe neither.
ELEMENTARY = catalogue.operations("ELEMENTARY_OPERATIONS")
# They are in no mean: float has expressions in their place.
AUXILIARY = catalogue.operations("AUXILIARY_OPERATIONS")
# The implementations whose square roots the first page compares.
ROOTS = (*((name, implementation) for name in catalogue.FORMATS for implementation in (OURS, "small")), FLOAT, PUBLISHED)

# ulp of a float that amount to half its value: no digit is right.
LOST = 2**23


def row(data, operation, number_format, implementation=OURS, operands="physics"):
    """The row of a class of operands; None if the operation does not exist."""
    rows = data.rows("operations", operation=operation, format=number_format,
                     implementation=implementation, operands=operands)
    return rows[0] if rows else None


def mean(data, operation, number_format, implementation=OURS):
    """Mean cycles; None if the operation does not exist."""
    found = row(data, operation, number_format, implementation)
    return found["cycles_mean"] if found else None


def names(data, number_format="q16_16", implementation=OURS):
    """The operations of an implementation, in the order of the data."""
    return list(dict.fromkeys(row["operation"] for row in data.rows(
        "operations", format=number_format, implementation=implementation)))


def every_ratio_to_float(data, number_format, implementation=OURS):
    """Mean cycles relative to those of avr-libc's float, for each operation that both have."""
    found = {}
    for operation in names(data, number_format, implementation):
        theirs = mean(data, operation, *FLOAT)
        if theirs is not None:
            found[operation] = mean(data, operation, number_format, implementation) / theirs
    return found


def ratios_to_float(data, number_format, implementation=OURS, elementary=False):
    """The part of these operations that has kernels, or the elementary functions."""
    return {operation: ratio for operation, ratio in every_ratio_to_float(data, number_format, implementation).items()
            if operation not in AUXILIARY and (operation in ELEMENTARY) == elementary}


def geometric_mean(values):
    values = list(values)
    return math.exp(sum(map(math.log, values)) / len(values))


def elementary_finding(data):
    """The cost of the functions beyond those of the front pages, in a sentence; empty if they were not measured."""
    ranges = []
    for number_format in catalogue.FORMATS:
        ratios = ratios_to_float(data, number_format, elementary=True)
        if ratios:
            slowest = max(ratios, key=ratios.get)
            ranges.append(f"{min(ratios.values()):.3g} to {ratios[slowest]:.3g} ({slowest}) in "
                          f"{style.format_label(number_format)}")
    return (f"Cycles of the {len(ELEMENTARY)} further functions ({', '.join(ELEMENTARY)}), as a multiple of float's: "
            f"{', '.join(ranges)}." if ranges else "")


def slower_than_float(data, number_format, implementation=OURS):
    """Operations that take more cycles than float's, the worst first, each with its ratio."""
    slow = {name: ratio for name, ratio
            in every_ratio_to_float(data, number_format, implementation).items() if ratio > 1}
    return sorted(slow.items(), key=lambda item: -item[1])


def flash_together(data, number_format, implementation=OURS):
    """Bytes of flash of a program with + - * / sqrt sin atan2 exp log; None if it does not have all of them."""
    rows = data.rows("flash", operations="nine", format=number_format, implementation=implementation)
    return rows[0]["flash_bytes"] if rows else None


def cheapest_format(data, largest, step):
    """Among the formats of the library that hold +-largest in steps no longer than `step`: the one with the fewest
    bits, then with the fewest cycles of a product."""
    fit = [each for each in data.rows("table_3_1") if each["format"] in catalogue.FORMATS
           and each["maximum"] >= largest and each["resolution"] <= step]
    return min(fit, key=lambda each: (each["bits"], mean(data, "multiply", each["format"])))


def power(value):
    """A limit of a format as text: whole numbers plain, others to three digits."""
    return f"{value:,.0f}".replace(",", "\u202f") if 1 <= value < 1e10 else f"{value:.3g}"


def losses(data, number_format, implementation):
    """Where an arithmetic loses against float, in words."""
    every = every_ratio_to_float(data, number_format, implementation)
    slow = slower_than_float(data, number_format, implementation)
    if not slow:
        return f"none of {len(every)} takes more cycles than float"
    shown = ", ".join([f"{slow[0][0]} {slow[0][1]:.3g} times float's cycles"]
                      + [f"{name} {ratio:.3g} times" for name, ratio in slow[1:2]])
    return shown + (f", and {len(slow) - 2} more" if len(slow) > 2 else "")


def largest_of(errors):
    """The largest error and its operation, as text; operations that are off by half their value or more are counted
    separately."""
    lost = sum(ulp >= LOST for ulp, _ in errors)
    ulp, name = max(error for error in errors if error[0] < LOST)
    return f"{ulp:.4g} ({name})" + (f"; *no digit* in {lost} of {len(errors)}" if lost else "")


def format_table(data):
    """The rows of the first page: an arithmetic, its range and resolution, its largest error, mean cycles, flash, and
    where it loses."""
    limits = {row["format"]: row for row in data.rows("table_3_1")}
    ratios = every_ratio_to_float(data, "q16_16").values()
    table = []
    for kind in [(name, OURS) for name in catalogue.FORMATS] + [FLOAT, PUBLISHED]:
        shown = names(data, *kind)
        if not shown:
            continue
        errors = [(found["max_ulp"], name) for name in shown
                  if (found := bounds.known(data, name, *kind))["bound"]]
        table.append({
            "kind": kind, "range": power(limits[kind[0]]["maximum"]),
            "resolution": f"{limits[kind[0]]['resolution']:.3g}" if kind != FLOAT else "2⁻²⁴ of the value",
            "ulp": largest_of(errors), "flash": flash_together(data, *kind),
            "cycles": [mean(data, name, *kind) for name in BASIC],
            "ratio": geometric_mean(ratios_to_float(data, *kind).values()) if kind != FLOAT else 1,
            "losses": losses(data, *kind) if kind != FLOAT else (
                f"slower than Q16.16 in {sum(ratio < 1 for ratio in ratios)} of {len(ratios)}")})
    return table


def correctly_rounded_finding(data):
    """What functions that round correctly cost compared with the default's, in a sentence for each format; empty if none
    was measured."""
    sentences = []
    for number_format in catalogue.FORMATS:
        kind = number_format, "correctly_rounded"
        known = {name: bounds.known(data, name, *kind) for name in names(data, *kind)}
        if not known:
            continue
        ratios = sorted((mean(data, name, *kind) / mean(data, name, number_format), name) for name in known)
        kinds = [each["bound"] for each in known.values()]
        told = ", ".join(f"{bound} in {kinds.count(bound)}" for bound in sorted(set(kinds)))
        sentences.append(
            f"{'In' if sentences else 'If you need correct rounding, in'} {style.format_label(number_format)} `CorrectlyRounded` errs by "
            f"at most {max(each['max_ulp'] for each in known.values()):.3g} ulp in {len(known)} functions (bound: {told}). It takes "
            f"{ratios[0][0]:.2g} ({ratios[0][1]}) to {ratios[-1][0]:.3g} ({ratios[-1][1]}) times the default's mean cycles, and up to "
            f"{max(each['cycles_max'] for each in known.values())} cycles near a tie.")
    return " ".join(sentences)


def least_flash(data):
    """Which arithmetic needs the least flash for a program of the nine operations, in a sentence."""
    rows = sorted(data.rows("flash", operations="nine"), key=lambda row: row["flash_bytes"])
    least, ours = rows[0], min((row for row in rows if row["format"] != "float"),
                               key=lambda row: row["flash_bytes"])
    text = (f"A program with the nine operations takes the least flash in {style.label(least['format'], least['implementation'])}: "
            f"{least['flash_bytes']} bytes")
    if least is not ours:
        text += (f"; the smallest of ours takes {ours['flash_bytes']} "
                 f"({style.label(ours['format'], ours['implementation'])})")
    return text + "."
