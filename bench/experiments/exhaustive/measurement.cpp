// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/exhaustive/measurement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <tuple>

namespace machine_code {
namespace {

std::vector<std::int64_t> operands_of(const reference::Witness& witness) {
    return {witness.operands().begin(), witness.operands().end()};
}

reference::Witness witness_of(const nlohmann::json& json) {
    return reference::Witness(json.get<std::vector<std::int64_t>>());
}

}  // namespace

void CycleStatistics::merge(const CycleStatistics& later) {
    calls += later.calls;
    regular_calls += later.regular_calls;
    regular_sum += later.regular_sum;
    min = std::min(min, later.min);
    if (later.max > max) {
        max = later.max;
        max_witness = later.max_witness;
    }
}

void Part::merge(const Part& later) {
    errors.merge(later.errors);
    cycles.merge(later.cycles);
    if (differences.count == 0) differences.witness = later.differences.witness;
    differences.count += later.differences.count;
}

bool Measurement::is_of_the_run_of(const Measurement& other) const {
    return std::tie(symbol, elf_sha256, kernel_sha256, every_input, search_operands,
                    has_portable) == std::tie(other.symbol, other.elf_sha256, other.kernel_sha256,
                                              other.every_input, other.search_operands,
                                              other.has_portable);
}

void Measurement::join(const Measurement& other) {
    const auto reject = [&](std::string_view why) {
        throw std::runtime_error(fmt::format("{}: the shards {}", symbol, why));
    };
    if (other.symbol != symbol || other.elf_sha256 != elf_sha256 ||
        other.kernel_sha256 != kernel_sha256 || other.every_input != every_input ||
        other.has_portable != has_portable)
        reject("are not of one program");
    if (!is_of_the_run_of(other))
        reject(fmt::format("are of searches of {} and of {} operands", search_operands,
                           other.search_operands));
    for (const auto& [index, part] : other.parts)
        if (!parts.emplace(index, part).second) reject("overlap");
    std::set<std::uint32_t> common;
    std::set_intersection(unreached.begin(), unreached.end(), other.unreached.begin(),
                          other.unreached.end(), std::inserter(common, common.end()));
    unreached = std::move(common);
}

Part Measurement::total() const {
    Part sum;
    for (const auto& [index, part] : parts) sum.merge(part);
    return sum;
}

void to_json(nlohmann::json& json, const Part& part) {
    json = {{"errors", part.errors},
            {"calls", part.cycles.calls},
            {"regular_calls", part.cycles.regular_calls},
            {"regular_cycles_sum", part.cycles.regular_sum},
            {"cycles_min", part.cycles.min},
            {"cycles_max", part.cycles.max},
            {"cycles_max_witness", operands_of(part.cycles.max_witness)},
            {"differences", part.differences.count},
            {"difference_witness", operands_of(part.differences.witness)}};
}

void from_json(const nlohmann::json& json, Part& part) {
    json.at("errors").get_to(part.errors);
    json.at("calls").get_to(part.cycles.calls);
    json.at("regular_calls").get_to(part.cycles.regular_calls);
    json.at("regular_cycles_sum").get_to(part.cycles.regular_sum);
    json.at("cycles_min").get_to(part.cycles.min);
    json.at("cycles_max").get_to(part.cycles.max);
    part.cycles.max_witness = witness_of(json.at("cycles_max_witness"));
    json.at("differences").get_to(part.differences.count);
    part.differences.witness = witness_of(json.at("difference_witness"));
}

void to_json(nlohmann::json& json, const Measurement& measurement) {
    nlohmann::json parts = nlohmann::json::object();
    for (const auto& [index, part] : measurement.parts) parts[fmt::to_string(index)] = part;
    json = {{"symbol", measurement.symbol},
            {"elf_sha256", measurement.elf_sha256},
            {"kernel_sha256", measurement.kernel_sha256},
            {"every_input", measurement.every_input},
            {"search_operands", measurement.search_operands},
            {"has_portable", measurement.has_portable},
            {"unreached", measurement.unreached},
            {"parts", parts}};
}

void from_json(const nlohmann::json& json, Measurement& measurement) {
    json.at("symbol").get_to(measurement.symbol);
    json.at("elf_sha256").get_to(measurement.elf_sha256);
    json.at("kernel_sha256").get_to(measurement.kernel_sha256);
    json.at("every_input").get_to(measurement.every_input);
    json.at("search_operands").get_to(measurement.search_operands);
    json.at("has_portable").get_to(measurement.has_portable);
    json.at("unreached").get_to(measurement.unreached);
    measurement.parts.clear();
    for (const auto& [index, part] : json.at("parts").items()) {
        std::uint64_t number = 0;
        const char* const end = index.data() + index.size();
        const auto [rest, bad] = std::from_chars(index.data(), end, number);
        if (bad != std::errc() || rest != end || number >= operations::exhaustive_parts)
            throw std::runtime_error(fmt::format("no part '{}': they are 0 to {}", index,
                                                 operations::exhaustive_parts - 1));
        measurement.parts.emplace(number, part.get<Part>());
    }
}

}  // namespace machine_code
