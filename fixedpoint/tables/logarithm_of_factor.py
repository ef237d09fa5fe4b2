#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes fixedpoint/src/fixedpoint/portable/logarithm_of_factor_table.hpp: the 8-bit factors that
bring a mantissa close to 1, and their logarithms, in exact integer arithmetic."""

from cordic import literal
from exponential_series import logarithm
from page import SOURCE, rows

NODES, ONE, BITS = 64, 256, 56
factors = [(2 * ONE * NODES // (NODES + i) + 1) // 2 for i in range(NODES + 1)]
logarithms = [literal(logarithm(ONE, factor, BITS), 64) for factor in factors]
newline = "\n        "

if __name__ == "__main__":
    (SOURCE / "portable/logarithm_of_factor_table.hpp").write_text(f"""\
// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/logarithm_of_factor.py
// For node i, 1 + i / {NODES}: 1 - decrease / {ONE} is the factor nearest to its reciprocal, and logarithm is
// that of the reciprocal of the factor, in units of 2^-{BITS}, like ln 2.
#pragma once

#include <stdint.h>

#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {{
namespace portable {{

// A template, with Any = void, since its static members may be defined in a header.
template <class Any = void>
struct LogarithmOfFactor {{
    static constexpr uint8_t decrease[{NODES + 1}] FIXEDPOINT_PROGRAM_MEMORY = {{
        {("," + newline).join(rows([ONE - factor for factor in factors]))}}};
    static constexpr uint64_t logarithm[{NODES + 1}] FIXEDPOINT_PROGRAM_MEMORY = {{
        {("," + newline).join(rows(logarithms, 3, "{}"))}}};
    static constexpr int64_t ln2() {{ return {literal(logarithm(2, 1, BITS), 64)}; }}
}};
template <class Any>
constexpr uint8_t LogarithmOfFactor<Any>::decrease[];
template <class Any>
constexpr uint64_t LogarithmOfFactor<Any>::logarithm[];

}}  // namespace portable
}}  // namespace fixedpoint
""")
