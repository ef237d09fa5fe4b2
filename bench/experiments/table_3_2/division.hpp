// SPDX-License-Identifier: GPL-3.0-or-later
// The cost of the published Q16.16 division and of the toolchain's float division, by operand, and
// the law that predicts the former: libgcc's 64-bit division skips the leading zero bytes of the
// quotient, and spends 8 cycles on each of its set bits.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/experiments/table_3_2/harness.hpp"
#include "bench/lab/records/record.hpp"

namespace table_3_2 {

struct Division {
    std::int32_t a, b;
    std::uint32_t cycles;  // including call and return
};

// The magnitude of a 2^16 / b before it is truncated to 32 bits. `b` must not be 0.
std::uint64_t published_quotient(std::int32_t a, std::int32_t b);
int quotient_bytes(std::int32_t a, std::int32_t b);  // without leading zero bytes

// 62 us were measured in the published engine while it ran.
constexpr double engine_division_cycles = 62e-6 * simulator::Chip::frequency;

// cycles = constant + per_byte * (bytes of the quotient) + per_one * (its set bits)
//          + negative_a [a < 0] + negative_b [b < 0] + both [both] + zero [quotient 0],
// by least squares.
struct DivisionLaw {
    double constant, per_byte, per_one, negative_a, negative_b, both, zero;
    double rms_residual, max_residual;

    double predict(std::int32_t a, std::int32_t b) const;
    // The bytes of the quotient of positive operands that takes this many cycles, if half of its
    // bits are ones.
    double bytes_for(double cycles) const { return (cycles - constant) / (per_byte + 4 * per_one); }
};
DivisionLaw fit_division_law(const std::vector<Division>& divisions);

struct DivisionCost {
    std::string operands;  // small, physics, full, published
    std::vector<std::uint32_t> fixed, floating;
};

struct DivisionStudy {
    std::vector<DivisionCost> costs;
    DivisionLaw law;
    std::vector<Division> divisions;
};

// `samples` random operand pairs of each class. `published` are the operands that fit the harness
// best.
DivisionStudy study_division(const std::filesystem::path& division_elf, const Operands& published,
                             int samples);

// A row of division_cycles.csv. Its kind is a bin of a `histogram`, 16 cycles wide, from `cycles`
// on; a `summary`; a `published` figure; or a coefficient of the `law`.
struct DivisionRow {
    std::string kind, operands;
    std::optional<double> cycles;
    std::optional<int> count;
    std::optional<double> value;
    std::string note;

    static constexpr auto columns = std::tuple(records::column("kind", &DivisionRow::kind),
                                               records::column("operands", &DivisionRow::operands),
                                               records::column("cycles", &DivisionRow::cycles),
                                               records::column("count", &DivisionRow::count),
                                               records::column("value", &DivisionRow::value),
                                               records::column("note", &DivisionRow::note));
};
std::vector<DivisionRow> division_rows(const DivisionStudy& study, double published_table_ms,
                                       double loop_cycles);

}  // namespace table_3_2
