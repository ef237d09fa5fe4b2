// SPDX-License-Identifier: GPL-3.0-or-later
// A format that may be suitable, run on the host and on the simulated chip.
#pragma once

#include <cstdint>
#include <optional>

#include "bench/experiments/advise/ranges.hpp"

namespace advise {

// A row of advice.csv, one per format.
struct Advice {
    std::string format;
    bool meets;  // meets the error, without overflow
    std::optional<int> bits_left;
    std::optional<std::uint64_t> overflows, underflows;  // in the format's own run
    double max_error, rms_error;
    std::optional<double> cycles_estimated, cycles_mean;
    std::optional<std::uint32_t> cycles_max;
    std::optional<std::uint32_t> flash_bytes, ram_bytes;
    std::optional<std::uint16_t> stack_bytes;
    std::uint64_t chip_steps = 0;  // the steps measured on the chip
    std::string failure;           // why it was not measured

    static constexpr auto columns = [] {
        using records::column;
        return std::tuple(
            column("format", &Advice::format), column("meets", &Advice::meets),
            column("bits_left", &Advice::bits_left), column("overflows", &Advice::overflows),
            column("underflows", &Advice::underflows), column("max_error", &Advice::max_error),
            column("rms_error", &Advice::rms_error),
            column("cycles_estimated", &Advice::cycles_estimated),
            column("cycles_mean", &Advice::cycles_mean), column("cycles_max", &Advice::cycles_max),
            column("flash_bytes", &Advice::flash_bytes), column("ram_bytes", &Advice::ram_bytes),
            column("stack_bytes", &Advice::stack_bytes), column("chip_steps", &Advice::chip_steps),
            column("failure", &Advice::failure));
    }();
};

// A format with its run on the host.
struct Candidate {
    Format format;
    std::vector<std::int64_t> outputs;  // patterns
    Operations operations;
    Advice advice;
};

// For each width, the finest split that holds everything and the next coarser one, since rounding
// may leave the range of the exact values; and the formats with names and kernels.
std::vector<Format> candidates(int integer_bits);

// Runs the program in each format and in float. A format in which it does not compile, because of a
// constant that does not fit, has a `failure`.
std::vector<Candidate> run_on_host(const Options& options, const std::filesystem::path& scratch,
                                   const std::filesystem::path& rows, std::vector<Format> formats,
                                   const Recorded& recorded);

// Builds the candidate for the chip and calls it with the data, from the first row of each run,
// until that has taken long enough. A result that differs from the host's is a failure, except for
// float, which is not the same on both: there the chip's result counts.
void measure_on_chip(const Options& options, const Data& data, const std::filesystem::path& scratch,
                     const std::vector<double>& exact, Candidate& candidate);

}  // namespace advise
