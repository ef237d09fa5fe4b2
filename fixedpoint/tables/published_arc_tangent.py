#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes src/fixedpoint/published/arc_tangent_table.hpp, the published table: atan(i / 200) for
i = 0..200 with 32 fraction bits, rounded to nearest."""

from fractions import Fraction

import page

INTERVALS = 200
FRACTION_BITS = 32


def arc_tangent(t):
    """atan(t) for 0 <= t <= 1 to within 2^-100, as a fraction: Euler's series
    sum over n of (2n)!! / (2n+1)!! * t^(2n+1) / (1+t^2)^(n+1), whose terms at least halve."""
    ratio = t * t / (1 + t * t)
    term = t / (1 + t * t)
    total = Fraction(0)
    n = 0
    while term > Fraction(1, 2**101):
        total += term
        n += 1
        # Truncation to 2^-160 per step is far below the bound; it keeps the fractions short.
        term = Fraction(int(term * ratio * Fraction(2 * n, 2 * n + 1) * 2**160), 2**160)
    return total


def entry(i):
    scaled = arc_tangent(Fraction(i, INTERVALS)) * 2**FRACTION_BITS
    return int(scaled + Fraction(1, 2))


values = [f"{entry(i):#011x}" for i in range(INTERVALS + 1)]
lines = ",\n".join("    " + row for row in page.rows(values, 7, "{}"))
(page.SOURCE / "published/arc_tangent_table.hpp").write_text(f"""// SPDX-License-Identifier: MIT
// DO NOT EDIT: written by python3 fixedpoint/tables/published_arc_tangent.py
// atan(i / {INTERVALS}), i = 0..{INTERVALS}, {FRACTION_BITS} fraction bits, rounded to nearest.
#pragma once

#include <stdint.h>
#ifdef __AVR__
#include <avr/pgmspace.h>
#endif

namespace fixedpoint {{
namespace published {{

constexpr uint8_t arc_tangent_intervals = {INTERVALS};

// A copy for each file that uses it, which the linker drops if it is not used.
#ifdef __AVR__
__attribute__((section(".progmem.data.fixedpoint_published_arc_tangent")))
#endif
static const uint64_t arc_tangent_table[arc_tangent_intervals + 1] = {{
{lines},
}};

static inline uint64_t arc_tangent_entry(uint8_t i) {{
#ifdef __AVR__
    uint64_t entry;
    memcpy_P(&entry, arc_tangent_table + i, sizeof entry);
    return entry;
#else
    return arc_tangent_table[i];
#endif
}}

}}  // namespace published
}}  // namespace fixedpoint
""")
