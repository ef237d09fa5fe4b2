// SPDX-License-Identifier: GPL-3.0-or-later
// What the report leaves open about its harness, as axes of which a hypothesis names one value
// each, and how well a hypothesis fits the published figures.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "bench/experiments/table_3_2/harness.hpp"

namespace table_3_2 {

struct Published {
    Cell cell;
    double ms;
};

// The 24 cells of the published table, then its functions.
std::vector<Published> load_published();

// One compiled variant of device/harness.cpp.
struct Program {
    std::filesystem::path elf;
    std::string flags, loop, operators, shift, widening;
};
std::vector<Program> load_programs(const std::filesystem::path& programs_csv);

struct Hypothesis {
    Program program;
    std::string form;
    Operands operands;
};

// The axes by name and the value that a hypothesis has on each, in words of the report.
constexpr std::array axes{"form", "operands", "flags", "loop", "operators", "shift", "widening"};
std::array<std::string, axes.size()> values(const Hypothesis& hypothesis);

// The axes on which two hypotheses differ.
std::vector<std::size_t> differences(const Hypothesis& a, const Hypothesis& b);

// Whether they differ on one axis, or on the form and one axis more.
bool is_alternative(const Hypothesis& best, const Hypothesis& other);

// Everything that is tried: each program with each form and each pair of operands.
const std::vector<std::string>& forms();
const std::vector<Operands>& operand_pairs();

// Short measurements: a few passes of the loop, without the timer's interrupt (half a percent).
double quick_ms(Harness& harness, const Hypothesis& hypothesis, const Cell& cell);

struct Fit {
    Hypothesis hypothesis;
    double log_ratio_sum = 0;  // over the rows, of |log(measured / published)|
    int within_10_percent = 0;
};

// All hypotheses, best first, measured by two threads, of which each calls `program_done` once a
// program.
std::vector<Fit> search(const std::vector<Program>& programs,
                        const std::vector<Published>& published,
                        const std::function<void()>& program_done);

// The hypothesis of the table, out of fits sorted best first. None whose floating-point operands
// only serve an early exit (no author times a division by zero knowingly; it remains an
// explanation of a cell), and where several are as good as equal, one with the toolchain's usual
// flags and an int counter.
const Fit& preferred(const std::vector<Fit>& fits);

// The hypothesis that is preferred after a search, for when there is none.
Hypothesis best_known(const std::vector<Program>& programs);

}  // namespace table_3_2
