# SPDX-License-Identifier: GPL-3.0-or-later
"""The library's building blocks beside float."""
import style

GOAL = 0.4  # of float's cycles


def finding(data):
    """For each fixed-point format, how many blocks reach the goal, and the one that saves least."""
    told = []
    for number_format in ("q8_8", "q16_16", "q8_24"):
        rows = data.rows("blocks", format=number_format)
        reached = sum(row["cycles_against_float"] <= GOAL for row in rows)
        worst = max(rows, key=lambda row: row["cycles_against_float"])
        told.append(f"{reached} of {len(rows)} in {style.format_label(number_format)} (the dearest, "
                    f"{worst['block'].replace('_', ' ')}: {worst['cycles_against_float']:.2f})")
    return (f"Building blocks (controllers, filters, tables, matrices, quaternions) that take at most {GOAL} of float's "
            f"cycles: {', '.join(told)}.")
