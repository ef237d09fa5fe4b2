# SPDX-License-Identifier: GPL-3.0-or-later
"""The library's building blocks compared with float."""
import catalogue
import style

GOAL = 0.4  # of float's cycles

# What the definition of a block takes: products and quotients.
WORK = {"pid": (3, 0), "biquad": (5, 0), "biquad_high_pass": (5, 0), "one_pole": (1, 0), "moving_average": (0, 0), "polynomial": (5, 0),
        "interpolation": (1, 0), "complex_product": (4, 0), "matrix_vector": (9, 0), "matrix_product_2": (8, 0),
        "matrix_product_3": (27, 0), "matrix_inverse_2": (2, 4), "matrix_inverse_3": (21, 9),
        "quaternion_turn": (24, 0), "quaternion_rotate": (15, 0)}


def float_cycles(data, row):
    return data.rows("blocks", block=row["block"], format="binary32")[0]["cycles_mean"]


def is_wide(row):
    """Whether the inputs, or the coefficients too, are in -4..4 or more."""
    return row["block"].endswith("_wide")


def share_of_work(data, row):
    """The fraction of float's cycles that the block's products and quotients alone take. The cost of a product is that
    of one more product in a dot product, including its loads."""
    cycles = {operation: data.rows("operations", operation=operation, format=row["format"], implementation="default",
                                   operands="small")[0]["cycles_mean"] for operation in ("dot2", "dot3", "divide")}
    products, quotients = WORK[row["block"]]
    return (products * (cycles["dot3"] - cycles["dot2"]) + quotients * cycles["divide"]) / float_cycles(data, row)


def finding(data):
    """For each fixed-point format, how many blocks reach the goal, the most expensive of the others, and their floor."""
    told, wide = [], []
    for number_format in dict.fromkeys(row["format"] for row in data.rows("blocks") if row["format"] in catalogue.FORMATS):
        every = data.rows("blocks", format=number_format)
        rows = [row for row in every if not is_wide(row)]
        shares = {row["block"]: row["cycles_mean"] / float_cycles(data, row) for row in every}
        wide_shares = [shares[row["block"]] for row in every if is_wide(row)]
        if wide_shares:
            wide.append(f"{min(wide_shares):.2f} to {max(wide_shares):.2f} in {style.format_label(number_format)}")
        above = [row for row in rows if shares[row["block"]] > GOAL]
        text = f"{len(rows) - len(above)} of {len(rows)} in {style.format_label(number_format)}"
        if above:
            worst = max((row["block"] for row in above), key=shares.get)
            floors = [share_of_work(data, row) for row in above]
            text += (f" (the others up to {shares[worst]:.3g}, {worst.replace('_', ' ')}; there the products "
                     f"and quotients that the definitions require take {min(floors):.2f} to {max(floors):.2f} by themselves)")
        told.append(text)
    return (f"Building blocks (controllers, filters, tables, matrices, quaternions) that take at most {GOAL} times float's "
            f"cycles on inputs in -1..1: {'; '.join(told)}. Outside of that range, sums of products in Q8.24 take more."
            + (f" On inputs in -4..4 (rows *_wide), blocks take {', '.join(wide)}." if wide else ""))


def limit_cycle_finding(data):
    """What filters with error feedback leave without input, and what they would leave without feedback."""
    rows = {feedback: data.rows("limit_cycles", error_feedback=feedback) for feedback in ("yes", "no")}
    held = max(row["largest_ulp"] for row in rows["yes"])
    worst = max(rows["no"], key=lambda row: row["largest_ulp"])
    return (f"Without input, the filters' outputs come to {held} ulp at most, within their bound; without error feedback, "
            f"sums rounded once stop at up to {worst['largest_ulp']} ulp ({worst['filter']} with a period of "
            f"{worst['time_constant_steps']} steps in {style.format_label(worst['format'])}).")
