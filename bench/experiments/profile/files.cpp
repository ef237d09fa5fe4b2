// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/profile/files.hpp"

#include <fmt/format.h>

#include <map>

#include "bench/chip/profile/flame_graph.hpp"
#include "bench/chip/profile/short_name.hpp"
#include "bench/lab/records/csv.hpp"
#include "bench/lab/records/whole_file.hpp"

namespace profile {
namespace {

double share(Cycle part, Cycle whole) {
    return whole ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

void append(std::vector<std::string>& row, const Spread& spread) {
    if (!spread.count) return row.insert(row.end(), 3, ""), void();
    row.push_back(fmt::format("{}", spread.min));
    row.push_back(fmt::format("{:.3f}", spread.mean()));
    row.push_back(fmt::format("{}", spread.max));
}

records::Table profile_table(const Profile& profile) {
    records::Table table({"function", "symbol", "calls", "self_cycles", "self_share",
                          "inclusive_cycles", "inclusive_share", "cycles_min", "cycles_mean",
                          "cycles_max"});
    for (const FunctionCost& function : profile.functions) {
        std::vector<std::string> row = {
            short_name(function.name),
            function.symbol,
            fmt::format("{}", function.calls),
            fmt::format("{}", function.self_cycles),
            fmt::format("{:.6f}", share(function.self_cycles, profile.elapsed)),
            fmt::format("{}", function.inclusive_cycles),
            fmt::format("{:.6f}", share(function.inclusive_cycles, profile.elapsed))};
        append(row, function.per_call);
        table.add(std::move(row));
    }
    return table;
}

records::Table interrupt_table(const Profile& profile) {
    records::Table table({"vector", "interrupt", "handler", "count", "latency_min", "latency_mean",
                          "latency_max", "duration_min", "duration_mean", "duration_max"});
    for (const InterruptCost& interrupt : profile.interrupts) {
        std::vector<std::string> row = {fmt::format("{}", interrupt.vector), interrupt.name,
                                        interrupt.handler, fmt::format("{}", interrupt.entries)};
        append(row, interrupt.latency);
        append(row, interrupt.duration);
        table.add(std::move(row));
    }
    return table;
}

// Measured beside the bound of all functions that ran or that the machine code can reach.
records::Table stack_table(const Profile& profile, const StackBound& bound) {
    struct Row {
        const FunctionCost* measured = nullptr;
        const FunctionBound* bound = nullptr;
    };
    std::map<std::string, Row> rows;
    for (const FunctionCost& function : profile.functions) rows[function.name].measured = &function;
    for (const FunctionBound& function : bound.functions) rows[function.name].bound = &function;

    records::Table table({"function", "frame_bytes_measured", "frame_bytes_bound",
                          "stack_bytes_measured", "stack_bytes_bound", "unbounded"});
    for (const auto& [name, row] : rows) {
        const auto measured = [&](unsigned FunctionCost::*bytes) {
            return row.measured ? fmt::format("{}", row.measured->*bytes) : "";
        };
        const auto bounded = [&](std::optional<unsigned> FunctionBound::*bytes) {
            return row.bound && row.bound->*bytes ? fmt::format("{}", *(row.bound->*bytes)) : "";
        };
        table.add({short_name(name), measured(&FunctionCost::frame_bytes),
                   bounded(&FunctionBound::frame_bytes), measured(&FunctionCost::stack_bytes),
                   bounded(&FunctionBound::stack_bytes), row.bound ? row.bound->unbounded : ""});
    }
    return table;
}

}  // namespace

void save_tables(const Profile& profile, const StackBound& bound, const std::string& program,
                 const std::filesystem::path& folder) {
    const auto file = [&](const char* kind, const char* suffix) {
        return folder / fmt::format("{}_{}.{}", kind, program, suffix);
    };
    profile_table(profile).save(file("profile", "csv"));
    interrupt_table(profile).save(file("interrupts", "csv"));
    stack_table(profile, bound).save(file("stack", "csv"));
    records::write_whole(file("stacks", "folded"), profile.folded());
}

void save_figure(const Profile& profile, const std::string& program,
                 const std::filesystem::path& folder) {
    records::write_whole(folder / (program + "_flame.svg"), flame_graph(profile, program + ".elf"));
}

}  // namespace profile
