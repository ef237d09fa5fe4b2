# SPDX-License-Identifier: GPL-3.0-or-later
"""The largest cycles and the largest error of an operation in any run, whether sampled, searched or over
all inputs, and what kind of maximum each is."""
import csv
import io

import catalogue
from data import DataError

OURS = "default"
# Proofs for every operand, tests of the library and of `exhaustive`: that a result is correctly rounded ...
SUMS = "bench/prove_sums", ("q16_16", "q8_24", "q8_16", "q12_12")
PROOFS = {(operation, number_format, implementation): proof
          for proof, formats, implementation, operations in (
              ("fixedpoint/prove_products", ("q8_16", "q12_12", "q16_16", "q8_24"), OURS,
               ("multiply", "multiply_add", "dot2", "dot3")),
              ("fixedpoint/prove_products", ("u8_8", "u16_16"), OURS, ("multiply",)),
              ("fixedpoint/prove_products", ("q32_32",), OURS, ("multiply", "dot2", "dot3")),
              ("fixedpoint/prove_products", ("q8_8",), OURS, ("dot2", "dot3")),
              ("fixedpoint/prove_saturating_products", ("q16_16",), "saturating", ("multiply",)),
              ("fixedpoint/prove_split_products", ("q8_16", "q12_12", "q8_24"), "saturating", ("multiply",)),
              ("fixedpoint/prove_quotients", ("q16_16",), OURS, ("divide",)),
              ("fixedpoint/prove_small_quotients", ("q16_16",), "small", ("divide",)),
              ("fixedpoint/prove_remainders", ("q16_16",), OURS, ("remainder", "divrem", "divmod")),
              ("fixedpoint/prove_quotients_q32_32", ("q32_32",), OURS, ("divide",)),
              ("fixedpoint/prove_roots", ("q32_32",), OURS, ("sqrt",)),
              # Lengths do not depend on where the point is: one kernel serves all formats of 32 bits.
              ("fixedpoint/prove_lengths", ("q16_16", "q8_24"), OURS, ("length2", "length3")),
              ("fixedpoint/prove_lengths", ("q16_16",), "correctly_rounded", ("length2", "length3")),
              ("fixedpoint/prove_short_lengths", ("q8_8",), OURS, ("length3",)),
              (*SUMS, OURS, ("add", "subtract", "abs_diff", "copysign", "midpoint")),
              (SUMS[0], ("q32_32",), OURS, ("add", "subtract", "abs_diff", "copysign", "midpoint")),
              (*SUMS, "saturating", ("add", "subtract")),
              (SUMS[0], ("q8_8",), OURS, ("multiply_add", "lerp")),
              ("bench/prove_nearest_angles", ("q16_16",), "correctly_rounded", ("atan2",)),
              (SUMS[0], ("q8_16", "q12_12"), OURS, ("divide", "remainder")),
              (*SUMS, OURS, ("lerp",)))
          for operation in operations for number_format in formats}
# ... or that its error is less than this, in ulp, whatever the largest known error is.
LIMITS = {("atan2", "q16_16", OURS): (0.645, "fixedpoint/prove_angles"),
          ("atan2", "q16_16", "small"): (0.651, "fixedpoint/prove_small_angles"),
          ("atan2_turns", "q8_8", OURS): (0.500001, "bench/prove_turns"),
          ("atan2_turns", "q16_16", OURS): (0.5001, "bench/prove_turns"),
          ("atan2_degrees", "q8_8", OURS): (0.5002, "bench/prove_turns"),
          ("atan2_degrees", "q16_16", OURS): (0.527, "bench/prove_turns"),
          ("cbrt", "q16_16", OURS): (0.54, "bench/prove_cube_roots"),
          ("log", "q8_24", OURS): (0.554, "bench/prove_cube_roots"),
          ("pow", "q8_8", OURS): (0.504, "bench/prove_powers"),
          ("pow", "q16_16", OURS): (0.75, "bench/prove_powers"),
          ("power", "q8_8", OURS): (0.50001, "bench/prove_integer_powers"),
          ("power", "q16_16", OURS): (0.635, "bench/prove_integer_powers"),
          ("normalise3", "q16_16", OURS): (0.77, "fixedpoint/prove_normalise"),
          ("normalise3", "q8_8", OURS): (0.66, "fixedpoint/prove_normalise")}
# ... or that it returns what other functions return, which were run over all inputs.
CALLS = {("sincos", "q16_16", implementation): (("sin", "cos"), "bench/prove_sincos")
         for implementation in ("small", "correctly_rounded")}
# Runs over all inputs are judged in double, to this fraction of an ulp (reference/bulk.hpp).
JUDGED_TO = 2**-14


def largest(named, runs, column, slack):
    """Value, witness, bound and file of the largest value of a column; all None if no run has it."""
    runs = [(file, row) for file, row in runs if row.get(column) is not None]
    if not runs:
        return None, None, None, None
    file, row = max(runs, key=lambda run: run[1][column])
    limits = [row[column] for _, row in runs if row["operands"] == "all"]
    if limits and row[column] > min(limits) + slack:
        raise DataError(f"{named}: {row[column]} in {column}, but a run over all inputs found at most {min(limits)}")
    return (row[column], row[f"{column}_witness"], "exact" if limits else "lower bound",
            f"{file}.csv, {row['operands']}")


def known(data, operation, number_format, implementation=OURS):
    """The row of bounds.csv; None if the operation does not exist. `bound` is that of the error: "exact" (all inputs
    were run), "proven", "proven below" a number or "lower bound". If nothing was judged, it and `max_ulp` are None.
    Raises DataError if two runs contradict each other."""
    what = {"operation": operation, "format": number_format, "implementation": implementation}
    sampled = data.rows("operations", **what)
    if not sampled:
        return None
    named = f"{operation}_{number_format}_{implementation}"
    whole = data.rows("exhaustive", **what) if data.has("exhaustive") else []
    for each in whole:
        if each["kernel_sha256"] != sampled[0]["kernel_sha256"]:
            raise DataError(f"exhaustive.csv and operations.csv measure different machine code of "
                            f"{named}: `fixbench exhaustive --symbol {named}` runs it again")
    # The portable code gives the same bits; some implementations have no results of their own.
    as_default = catalogue.IMPLEMENTATIONS.get(implementation, {}).get("as_default")
    judged = data.rows("accuracy", **what | ({"implementation": OURS} if as_default else {})) if data.has("accuracy") else []
    runs = [(file, row) for file, rows in (("operations", sampled), ("exhaustive", whole), ("accuracy", judged))
            for row in rows]
    cycles, cycles_witness, cycles_bound, cycles_run = largest(named, runs, "cycles_max", 0)
    ulp, ulp_witness, bound, ulp_run = largest(named, runs, "max_ulp", JUDGED_TO)
    kind = tuple(what.values())
    proof = PROOFS.get(kind) if bound else None
    if proof:
        bound = "proven"
        if ulp > 0.5 + JUDGED_TO:
            raise DataError(f"{named}: {ulp} in max_ulp, but {proof} proves at most half")
    elif bound and kind in LIMITS:
        limit, proof = LIMITS[kind]
        bound = f"proven below {limit}"
        if ulp >= limit:
            raise DataError(f"{named}: {ulp} in max_ulp, but {proof} proves less than {limit}")
    elif bound and kind in CALLS:
        names, proof = CALLS[kind]
        parts = [known(data, name, number_format, implementation) for name in names]
        if all(part and part["bound"] == "exact" for part in parts):
            worst = max(parts, key=lambda part: part["max_ulp"])
            if ulp > worst["max_ulp"] + JUDGED_TO:
                raise DataError(f"{named}: {ulp} in max_ulp, but {' and '.join(names)} err by at most {worst['max_ulp']}")
            ulp, ulp_witness, bound, ulp_run = (worst[key] for key in ("max_ulp", "max_ulp_witness", "bound", "ulp_run"))
        else:
            proof = None
    return what | {"cycles_max": cycles, "cycles_max_witness": cycles_witness, "cycles_bound": cycles_bound,
                   "cycles_run": cycles_run, "max_ulp": ulp, "max_ulp_witness": ulp_witness,
                   "bound": bound, "ulp_run": ulp_run, "proof": proof}


def table(data):
    """All rows of bounds.csv, in the order of operations.csv."""
    kinds = dict.fromkeys((row["operation"], row["format"], row["implementation"]) for row in data.rows("operations"))
    return [known(data, *kind) for kind in kinds]


def text(data):
    """bounds.csv."""
    rows, made = table(data), io.StringIO()
    writer = csv.DictWriter(made, rows[0], lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return made.getvalue()
