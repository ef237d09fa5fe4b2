// SPDX-License-Identifier: GPL-3.0-or-later
// A function of a user's program on the simulated chip, compared with what it claims to compute.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "bench/experiments/judge/claim.hpp"
#include "bench/lab/records/record.hpp"
#include "bench/lab/subjects/measurement.hpp"

namespace judge {

// A row of judge.csv: the result for one class of operands.
struct Figures {
    std::string function, claim, operands;
    std::uint64_t samples, regular;  // regular: Judgement::regular()
    // Missing if no chip was measured.
    std::optional<std::uint32_t> cycles_min;
    std::optional<double> cycles_mean;  // over the regular operands, or over all if none is regular
    std::optional<std::uint32_t> cycles_max;
    std::string cycles_max_witness;
    std::optional<std::uint16_t> stack_bytes;
    // Missing if no result was judged.
    std::optional<double> max_ulp;
    std::string max_ulp_witness;
    std::optional<double> rms_ulp, mean_ulp;
    std::string bound;
    std::uint64_t excluded, violations;
    std::string first_violation;

    static constexpr auto columns = [] {
        using records::column;
        return std::tuple(
            column("function", &Figures::function), column("claim", &Figures::claim),
            column("operands", &Figures::operands), column("samples", &Figures::samples),
            column("regular", &Figures::regular), column("cycles_min", &Figures::cycles_min),
            column("cycles_mean", &Figures::cycles_mean),
            column("cycles_max", &Figures::cycles_max),
            column("cycles_max_witness", &Figures::cycles_max_witness),
            column("stack_bytes", &Figures::stack_bytes), column("max_ulp", &Figures::max_ulp),
            column("max_ulp_witness", &Figures::max_ulp_witness),
            column("rms_ulp", &Figures::rms_ulp), column("mean_ulp", &Figures::mean_ulp),
            column("bound", &Figures::bound), column("excluded", &Figures::excluded),
            column("violations", &Figures::violations),
            column("first_violation", &Figures::first_violation));
    }();
};

// The columns that follow from the errors. The bound is a lower bound.
Figures figures_of(const Claim& claim, const reference::ErrorStatistics& errors);

struct ProgramOptions {
    std::filesystem::path program;
    std::string function;  // its symbol, or its name in C++
    std::string claim;
    std::optional<double> bound_ulp;
    std::uint64_t samples = 2000;  // of each random class and of the boundary table
    std::filesystem::path output;  // folder for judge.csv
    unsigned threads = 1;
};

// Writes judge.csv and returns the number of faults: results that contradict the claim, and 1 for a
// function that does not return, breaks the calling convention, writes where it must not or has
// another signature than the claim says. Each fault is a line on stderr. Throws
// std::invalid_argument if the program has no such function or the claim is invalid.
std::uint64_t judge_program(const ProgramOptions& options);

}  // namespace judge
