// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/lab/subjects/host_subject.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "bench/lab/catalogue/subjects.h"

namespace operations {

// Each is defined in its own translation unit.
#define DECLARE_ADDER(format, ...) void add_##format(std::vector<HostSubject>& subjects);
LIBRARY_FORMATS(DECLARE_ADDER)
UNSIGNED_FORMATS(DECLARE_ADDER)
void add_conversions(std::vector<HostSubject>& subjects);

std::string operation_name(const reference::Subject& subject) {
    const std::string_view name = reference::shape(subject.operation).name;
    if (subject.operation != reference::Operation::convert) return std::string(name);
    return fmt::format("{}_{}", name, reference::format_name(subject.operand_format));
}

std::string HostSubject::name() const {
    return fmt::format("{}_{}_{}", operation_name(subject), reference::format_name(subject.format),
                       implementation);
}

int HostSubject::input_bits() const {
    return subject.operand_format.width *
           static_cast<int>(reference::shape(subject.operation).operands);
}

reference::Judgement HostSubject::judge_own(Raws operands) const {
    std::array<std::int64_t, reference::max_results> results;
    const std::span computed =
        std::span(results).first(reference::shape(subject.operation).results);
    evaluate(operands, computed);
    return judge(operands, computed);
}

reference::ErrorStatistics HostSubject::exhaust(std::uint64_t part) const {
    constexpr std::size_t calls_of_a_batch = 512;  // whose raws fit the first-level cache
    const reference::OperationShape& shape = reference::shape(subject.operation);
    const std::uint64_t share = (std::uint64_t(1) << input_bits()) / exhaustive_parts;
    const int width = subject.operand_format.width;
    std::vector<std::int64_t> operands, results;
    reference::ErrorStatistics statistics;
    for (std::uint64_t first = part * share; first < (part + 1) * share;) {
        const std::uint64_t last = std::min(first + calls_of_a_batch, (part + 1) * share);
        operands.resize((last - first) * shape.operands);
        results.resize((last - first) * shape.results);
        auto operand = operands.begin();
        for (; first < last; ++first)
            for (std::size_t k = 0; k < shape.operands; ++k)
                *operand++ = subject.operand_format.extend(first >> (static_cast<int>(k) * width));
        evaluate(operands, results);
        judge_all(operands, results, statistics, {});
    }
    return statistics;
}

const std::vector<HostSubject>& host_subjects() {
    static const std::vector<HostSubject> all = [] {
        std::vector<HostSubject> subjects;
#define ADD_FORMAT(format, ...) add_##format(subjects);
        LIBRARY_FORMATS(ADD_FORMAT)
        UNSIGNED_FORMATS(ADD_FORMAT)
        add_conversions(subjects);
        return subjects;
    }();
    return all;
}

}  // namespace operations
