// SPDX-License-Identifier: GPL-3.0-or-later
// What many calls of one function cost and how large their errors are.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "bench/lab/subjects/device_subject.hpp"
#include "reference/error_statistics.hpp"

namespace operations {

struct Measurement {
    std::uint64_t samples = 0;
    std::uint32_t cycles_min = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t cycles_max = 0;
    std::uint64_t cycles_sum = 0;
    std::uint64_t regular = 0, regular_cycles_sum = 0;
    reference::Witness cycles_max_witness{};
    std::uint16_t stack_bytes = 0;
    reference::ErrorStatistics errors{};
    // In the unit of the result, so that formats can be compared.
    double max_error = 0;
    long double sum_of_squared_errors = 0;  // squares of a float64's errors are beyond a double

    void add(std::span<const std::int64_t> operands, const DeviceResult& result,
             const reference::Judgement& judgement) {
        ++samples;
        cycles_sum += result.cycles;
        cycles_min = std::min(cycles_min, result.cycles);
        stack_bytes = std::max(stack_bytes, result.stack_bytes);
        if (result.cycles > cycles_max) {
            cycles_max = result.cycles;
            cycles_max_witness = reference::Witness(operands);
        }
        errors.add(judgement, operands);
        if (!judgement.regular()) return;
        ++regular;
        regular_cycles_sum += result.cycles;
        if (!std::isfinite(judgement.error_ulp)) return;
        max_error = std::max(max_error, judgement.error);
        sum_of_squared_errors += static_cast<long double>(judgement.error) * judgement.error;
    }
    double rms_error() const {
        return static_cast<double>(
            std::sqrt(sum_of_squared_errors / static_cast<long double>(regular)));
    }
    // Over the regular operands, or over all if none is regular.
    double cycles_mean() const {
        return regular > 0 ? static_cast<double>(regular_cycles_sum) / static_cast<double>(regular)
                           : static_cast<double>(cycles_sum) / static_cast<double>(samples);
    }
};

// The cycles that the random operands of a measurement may take: the portable functions of the
// 64-bit formats cost up to half a million cycles a call.
constexpr std::uint64_t measurement_cycles = 60'000'000;

// Input spaces of up to this size are measured completely, as a class of their own.
constexpr int all_inputs_bits = 16;

}  // namespace operations
