// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/profile/files.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <vector>

#include "bench/chip/profile/flame_graph.hpp"
#include "bench/chip/profile/short_name.hpp"
#include "bench/lab/records/record.hpp"
#include "bench/lab/records/whole_file.hpp"

namespace profile {
namespace {

double share(Cycle part, Cycle whole) {
    return whole ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

using records::column;

// Minimum, mean and maximum; empty if there are none.
struct Cells {
    std::optional<Cycle> min, max;
    std::optional<double> mean;

    explicit Cells(const Spread& spread) {
        if (!spread.count) return;
        min = spread.min;
        mean = spread.mean();
        max = spread.max;
    }
};

// A row of profile_<program>.csv.
struct FunctionRow {
    std::string function, symbol;
    std::uint64_t calls, self_cycles;
    double self_share;
    std::uint64_t inclusive_cycles;
    double inclusive_share;
    std::optional<Cycle> cycles_min;
    std::optional<double> cycles_mean;
    std::optional<Cycle> cycles_max;

    static constexpr auto columns = std::tuple(
        column("function", &FunctionRow::function), column("symbol", &FunctionRow::symbol),
        column("calls", &FunctionRow::calls), column("self_cycles", &FunctionRow::self_cycles),
        column("self_share", &FunctionRow::self_share, "{:.6f}"),
        column("inclusive_cycles", &FunctionRow::inclusive_cycles),
        column("inclusive_share", &FunctionRow::inclusive_share, "{:.6f}"),
        column("cycles_min", &FunctionRow::cycles_min),
        column("cycles_mean", &FunctionRow::cycles_mean, "{:.3f}"),
        column("cycles_max", &FunctionRow::cycles_max));
};

std::vector<FunctionRow> function_rows(const Profile& profile) {
    std::vector<FunctionRow> rows;
    for (const FunctionCost& function : profile.functions) {
        const Cells call(function.per_call);
        rows.push_back(
            {short_name(function.name), function.symbol, function.calls, function.self_cycles,
             share(function.self_cycles, profile.elapsed), function.inclusive_cycles,
             share(function.inclusive_cycles, profile.elapsed), call.min, call.mean, call.max});
    }
    return rows;
}

// A row of interrupts_<program>.csv.
struct InterruptRow {
    unsigned vector;
    std::string interrupt, handler;
    std::uint64_t count;
    std::optional<Cycle> latency_min;
    std::optional<double> latency_mean;
    std::optional<Cycle> latency_max, duration_min;
    std::optional<double> duration_mean;
    std::optional<Cycle> duration_max;

    static constexpr auto columns = std::tuple(
        column("vector", &InterruptRow::vector), column("interrupt", &InterruptRow::interrupt),
        column("handler", &InterruptRow::handler), column("count", &InterruptRow::count),
        column("latency_min", &InterruptRow::latency_min),
        column("latency_mean", &InterruptRow::latency_mean, "{:.3f}"),
        column("latency_max", &InterruptRow::latency_max),
        column("duration_min", &InterruptRow::duration_min),
        column("duration_mean", &InterruptRow::duration_mean, "{:.3f}"),
        column("duration_max", &InterruptRow::duration_max));
};

std::vector<InterruptRow> interrupt_rows(const Profile& profile) {
    std::vector<InterruptRow> rows;
    for (const InterruptCost& interrupt : profile.interrupts) {
        const Cells latency(interrupt.latency), duration(interrupt.duration);
        rows.push_back({static_cast<unsigned>(interrupt.vector), interrupt.name, interrupt.handler,
                        interrupt.entries, latency.min, latency.mean, latency.max, duration.min,
                        duration.mean, duration.max});
    }
    return rows;
}

// A row of stack_<program>.csv: the measured stack, next to the bound over all functions that ran
// or that the machine code can reach.
struct StackRow {
    std::string function;
    std::optional<unsigned> frame_bytes_measured, frame_bytes_bound, stack_bytes_measured,
        stack_bytes_bound;
    std::string unbounded;

    static constexpr auto columns =
        std::tuple(column("function", &StackRow::function),
                   column("frame_bytes_measured", &StackRow::frame_bytes_measured),
                   column("frame_bytes_bound", &StackRow::frame_bytes_bound),
                   column("stack_bytes_measured", &StackRow::stack_bytes_measured),
                   column("stack_bytes_bound", &StackRow::stack_bytes_bound),
                   column("unbounded", &StackRow::unbounded));
};

std::vector<StackRow> stack_rows(const Profile& profile, const StackBound& bound) {
    std::map<std::string, StackRow> rows;
    for (const FunctionCost& function : profile.functions) {
        StackRow& row = rows[function.name];
        row.frame_bytes_measured = function.frame_bytes;
        row.stack_bytes_measured = function.stack_bytes;
    }
    for (const FunctionBound& function : bound.functions) {
        StackRow& row = rows[function.name];
        row.frame_bytes_bound = function.frame_bytes;
        row.stack_bytes_bound = function.stack_bytes;
        row.unbounded = function.unbounded;
    }
    std::vector<StackRow> sorted;
    for (auto& [name, row] : rows) {
        row.function = short_name(name);
        sorted.push_back(std::move(row));
    }
    return sorted;
}

}  // namespace

void save_tables(const Profile& profile, const StackBound& bound, const std::string& program,
                 const std::filesystem::path& folder) {
    const auto file = [&](const char* kind, const char* suffix) {
        return folder / fmt::format("{}_{}.{}", kind, program, suffix);
    };
    records::table_of(function_rows(profile)).save(file("profile", "csv"));
    records::table_of(interrupt_rows(profile)).save(file("interrupts", "csv"));
    records::table_of(stack_rows(profile, bound)).save(file("stack", "csv"));
    records::write_whole(file("stacks", "folded"), profile.folded());
}

void save_figure(const Profile& profile, const std::string& program,
                 const std::filesystem::path& folder) {
    records::write_whole(folder / (program + "_flame.svg"), flame_graph(profile, program + ".elf"));
}

}  // namespace profile
