// SPDX-License-Identifier: GPL-3.0-or-later
// What the publication leaves open about its harness, as axes. A hypothesis has one value on each
// axis. How well a hypothesis fits the published figures.
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

// The names of the axes; the value of a hypothesis on each is in the publication's words.
constexpr std::array axes{"form", "operands", "flags", "loop", "operators", "shift", "widening"};
std::array<std::string, axes.size()> values(const Hypothesis& hypothesis);

// The axes on which two hypotheses differ.
std::vector<std::size_t> differences(const Hypothesis& a, const Hypothesis& b);

// Whether they differ on one axis, or on the form and one more axis.
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

// All hypotheses, best first, measured by two threads. Each calls `program_done` once per program.
std::vector<Fit> search(const std::vector<Program>& programs,
                        const std::vector<Published>& published,
                        const std::function<void()>& program_done);

// The hypothesis for the table, from fits sorted best first. Excludes those whose floating-point
// operands only serve an early exit (no author times a division by zero knowingly; it may still
// explain a single cell). Of several that fit equally well, prefers one with the toolchain's usual
// flags and an int counter.
const Fit& preferred(const std::vector<Fit>& fits);

// The hypothesis that a search prefers, for runs without a search.
Hypothesis best_known(const std::vector<Program>& programs);

}  // namespace table_3_2
