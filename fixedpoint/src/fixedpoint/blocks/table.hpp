// SPDX-License-Identifier: MIT
/// \file
/// Table: the constants of a block, in program memory, where they do not take RAM.
#pragma once

#include <fixedpoint/integer.hpp>
#include <fixedpoint/program_memory.hpp>

namespace fixedpoint {

/// N constants for polynomials and interpolation. On the chip a table is read from program memory,
/// so it must be placed there:
///
///     static const Table<Q16_16, 3> table FIXEDPOINT_PROGRAM_MEMORY = {{1_q16_16, ...}};
template <class Number, uint16_t N>
struct Table {
    static_assert(N >= 1, "A table needs at least one entry.");
    /// The entries. On the chip, read them only by operator[].
    Number entry[N];

    /// Entry i; i must be less than N.
    Number operator[](uint16_t i) const {
#ifdef __AVR__
        using Bits = UnsignedInteger<8 * sizeof(Number)>;
        const Bits bits = load_program_memory(reinterpret_cast<const Bits*>(&entry[i]));
        Number number;
        __builtin_memcpy(&number, &bits, sizeof number);
        return number;
#else
        return entry[i];
#endif
    }
};

}  // namespace fixedpoint
