// SPDX-License-Identifier: GPL-3.0-or-later
// The results of running a function over a space of inputs, part by part, so that the sums of a run
// do not depend on the number of threads and shards.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "bench/experiments/exhaustive/oracle.hpp"
#include "reference/error_statistics.hpp"

namespace machine_code {

struct CycleStatistics {
    std::uint64_t calls = 0;
    std::uint64_t regular_calls = 0, regular_sum = 0;  // with Judgement::regular()
    std::uint32_t min = std::numeric_limits<std::uint32_t>::max(), max = 0;
    reference::Witness max_witness;  // the first

    void add(std::uint32_t cycles, bool regular, std::span<const std::int64_t> operands) {
        ++calls;
        regular_calls += regular;
        regular_sum += regular ? cycles : 0;
        if (cycles < min) min = cycles;
        if (cycles > max) [[unlikely]] {
            max = cycles;
            max_witness = reference::Witness(operands);
        }
    }
    void merge(const CycleStatistics& later);
    // Over the regular calls: calls that leave early say something about the operands, not about
    // the function.
    std::optional<double> mean() const {
        if (regular_calls == 0) return std::nullopt;
        return double(regular_sum) / double(regular_calls);
    }
};

struct Part {
    reference::ErrorStatistics errors;
    CycleStatistics cycles;
    Differences differences;

    void merge(const Part& later);
};

struct Measurement {
    std::string symbol, elf_sha256, kernel_sha256;
    bool every_input = false;           // every input was run; otherwise it was a search
    std::uint64_t search_operands = 0;  // if it was a search
    bool has_portable = false;
    std::map<std::uint64_t, Part> parts;  // of operations::exhaustive_parts
    std::set<std::uint32_t> unreached;    // flash byte addresses

    // Whether both measure the same function of the same program in the same way, so that their
    // parts belong to one run.
    bool is_of_the_run_of(const Measurement& other) const;
    // Throws std::runtime_error if the two are not of one run, or share a part.
    void join(const Measurement& other);
    bool is_complete() const { return parts.size() == operations::exhaustive_parts; }
    Part total() const;
};

void to_json(nlohmann::json& json, const Measurement& measurement);
void from_json(const nlohmann::json& json, Measurement& measurement);

}  // namespace machine_code
